// What resolve.h settles about articles and other determiners, and the pieces around a piece.
//
// Thread: pure.  Cost: linear in the pieces.
#pragma once

#include "dialogue/template/parse.h"

#include <vector>

namespace fulcrum::dialogue {

/// The piece before `at` that belongs in the sentence, or kNone.
[[nodiscard]] int before(const std::vector<Piece>& pieces, int at);

/// The piece after `at` that belongs in the sentence, or kNone.
[[nodiscard]] int after(const std::vector<Piece>& pieces, int at);

/// "The the egg", "my a longer tail": of two determiners side by side one goes.
void part_determiners(std::vector<Piece>& pieces, int at);

/// "The heavier than": without "than" it is right. "The heaviest" of two is heavier, and goes without "the": one error.
void drop_the(std::vector<Piece>& pieces, int adjective);

/// "Nearest to the Sun": which one is told, so it needs no "the"; alone, "is nearest", a superlative has it.
void allow_bare_nearest(std::vector<Piece>& pieces, int adjective);

/// A literal a or an, by the sound of the next word.
void sound(std::vector<Piece>& pieces, int at);

}  // namespace fulcrum::dialogue
