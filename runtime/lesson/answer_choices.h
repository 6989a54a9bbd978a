// Answers to choose from, for who neither types nor speaks: whole sentences of the question's own, one of them right by the lesson's
// verdict, the others of other meanings, in an order that is the question's own each time.
//
// Thread: that of the run.  Cost: at most kMostChoiceWalks sentences, and a verdict for each meaning among them.
#pragma once

#include "dialogue/marking/question.h"
#include "haptics/base/error.h"
#include "runtime/lesson/learner_model.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

inline constexpr std::size_t kMostChoices = 4;
inline constexpr int kMostChoiceWalks = 1000;

struct AnswerChoice {
    std::string said;
    bool right = false;  ///< in meaning, as things stand
    AnswerSlots meaning{};
};

/// At most kMostChoices answers, right in form. Without a right one where none is found. An error is the lesson's own, from its verdict.
[[nodiscard]] Expected<std::vector<AnswerChoice>> make_choices(const dialogue::Question& question,
                                                               const Verdict& verdict);

}  // namespace fulcrum::runtime
