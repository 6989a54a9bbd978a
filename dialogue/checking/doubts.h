// What is too uncertain to be called an error in a free sentence, and enough not to tell that sentence to anybody as good English.
//
// Thread: pure.  Cost: linear in the words.
#pragma once

#include "dialogue/checking/reading.h"

namespace fulcrum::dialogue {

/// Something in `sentence` may be no English: "the kite is fly", "near hand" where the hand is there, "planets they are", a word that the
/// lexicon doesn't have. A judge of sentences lets all of these pass.
[[nodiscard]] bool is_doubtful(const FreeSentence& sentence);

}  // namespace fulcrum::dialogue
