// An answer, marked: as one sentence, or sentence by sentence where that is understood better. It may be of several, or of one and
// what it rules out: "Eight. There are eight planets.", "The apple. It is heavier.", "The apple, not the egg.", "No, the apple is
// heavier!" Each is marked alone. The whole is right where all that is said is right and nothing that is ruled out is; where one of
// them is not understood, neither is the whole, for it may take back what the others say.
//
// Thread: pure.  Cost: some matches for each of at most five sentences.
#pragma once

#include "dialogue/marking/mark.h"
#include "dialogue/marking/question.h"

#include <string_view>

namespace fulcrum::dialogue {

/// Marks `text` as an answer to `question`.
[[nodiscard]] Mark mark_answer(const Question& question, std::string_view text,
                               double confidence = 1.0);

}  // namespace fulcrum::dialogue
