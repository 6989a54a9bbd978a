// A simulated learner who knows what is right and makes mistakes at chosen rates: answers are made from the question's own
// sentences, right ones and those with the errors that learners make, and the lesson says which meaning is right.
//
// Thread: that of the run.  Cost: at most kMostWalks sentences and verdicts an answer.
#pragma once

#include "dialogue/marking/question.h"
#include "dialogue/template/sentences.h"
#include "haptics/base/error.h"
#include "haptics/math/split_mix.h"
#include "runtime/scene/description.h"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

inline constexpr int kMostWalks = 1000;

using AnswerSlots = std::vector<std::pair<std::string, std::string>>;
/// Is that meaning right?
using Verdict = std::function<Expected<bool>(const AnswerSlots&)>;

class LearnerModel {
  public:
    /// The same seed gives the same answers to the same questions.
    LearnerModel(const LearnerRates& rates, std::uint64_t seed) : rates_(rates), chance_(seed) {}

    /// An answer of a kind that is drawn by the rates; where the question has none of that kind, a right one; "I don't know" where
    /// none is found either. An error is the lesson's own, from its verdict.
    [[nodiscard]] Expected<std::string> answer(const dialogue::Question& question,
                                               const Verdict& verdict);

  private:
    enum class Kind : std::uint8_t { right, wrong, form, unclear };

    [[nodiscard]] Kind draw_kind();
    [[nodiscard]] std::string draw_sentence(const dialogue::TemplateSet& set, bool errors);

    LearnerRates rates_;
    SplitMix chance_;
};

}  // namespace fulcrum::runtime
