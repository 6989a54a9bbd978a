// Answers that say something else of their words than that they are right: "the egg is not heavier", "they weigh the same", "on top".
// So do several sentences, each of which has to be right (mark_answer.h). What they claim is asked of the lesson in its own terms, a
// meaning for each word that could be meant, and follows from its verdicts.
//
// Thread: pure.  Cost: linear in the words of one list, kMostReadings at most.
#pragma once

#include "dialogue/marking/mark.h"
#include "dialogue/marking/question.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

/// Slots with their values.
using Slots = std::vector<std::pair<std::string, std::string>>;

inline constexpr std::size_t kMostReadings = 24;  ///< of one answer; longer lists are numbers

/// Fills `mark.claim` and `mark.readings` for what `graph` says. Where the question names two, not the one is the other.
void find_readings(const Question& question, const Graph& graph, Mark& mark);

/// The meanings that the lesson is asked about, one at least.
[[nodiscard]] std::vector<Slots> readings_of(const Mark& mark);

/// Whether the claim is true, by the verdicts on its readings, in their order. Where a word was not said, `mark.slots` gets one with which
/// the verdict is the same. Of `every`, where some are right and some are not, the mark is not understood any more.
[[nodiscard]] bool settle(Mark& mark, const std::vector<bool>& verdicts);

}  // namespace fulcrum::dialogue
