// Answers to choose from, for who neither types nor speaks: whole sentences of the question's own, one of them right by the lesson's
// verdict, in an order that is the question's own each time.
//
// They are made of the question's first answer, which is the taught one, and of what is in play: the two where it asks between two, else
// what is seen. Each wrong one is the right one with another word at one place, or with two words in each other's places; no word stands
// twice in one, nor beside its opposite. Where the first answer gives none such, the next one that does; else wrong ones of any answer; where nothing is wrong, right ones.
//
// Thread: that of the run.  Cost: a verdict for each meaning that is tried, at most kMostChoiceWalks.
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

/// At most kMostChoices answers, right in form. Without a right one where none is found. `seen`: what stands in sight is called, and what
/// it is made of. An error is the lesson's own, from its verdict.
[[nodiscard]] Expected<std::vector<AnswerChoice>> make_choices(
    const dialogue::Question& question, const Verdict& verdict,
    const std::vector<std::string>& seen = {});

}  // namespace fulcrum::runtime
