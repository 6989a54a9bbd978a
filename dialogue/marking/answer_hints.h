// What of a question's first answer may be shown before one is given: the whole of it as an example, a frame to fill, and the choices.
//
// Thread: pure.  Cost: a sentence made for each word that may be said.
#pragma once

#include "dialogue/marking/question.h"

#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// The whole right sentence of the question's first answer with every slot as "…": "… is the heaviest."; empty when it is
/// nothing but slots.
[[nodiscard]] std::string sentence_frame(const Question& question);

/// The first answer with the first word of each list: "A watermelon is the heaviest."
[[nodiscard]] std::string example_sentence(const Question& question);

/// What may be said for the slots, each once, with its article: "a watermelon", "an apple".
[[nodiscard]] std::vector<std::string> choices(const Question& question);

}  // namespace fulcrum::dialogue
