// An answer of several sentences, or of one and what it rules out: "Eight. There are eight planets.", "The apple. It is heavier.",
// "The apple, not the egg.", "No, the apple is heavier!" Each is marked alone. The whole is right where all that is said is right and
// nothing that is ruled out is; where one of them is not understood, neither is the whole, for it may take back what the others say.
//
// Thread: pure.  Cost: some matches for each of at most kMostSentences_said sentences.
#pragma once

#include "dialogue/marking/mark.h"
#include "dialogue/marking/question.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

inline constexpr std::size_t kMostSentences_said = 5;  ///< of one answer

/// The same answer as `whole`, sentence by sentence, where that is understood better than `whole`; else none.
[[nodiscard]] std::optional<Mark> mark_sentences(const Question& question, const Mark& whole);

}  // namespace fulcrum::dialogue
