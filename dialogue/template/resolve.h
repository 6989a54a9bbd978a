// Settles what depends on more than one place of a sentence, once its path is known: the verb agrees with the noun before
// it, a counted noun with its number, "the" doesn't go before "heavier than", a or an goes by the sound of the next word. What
// only looks like an error is let pass: "apples are heavier", all of them, where one is there; "nearer the stone".
//
// Thread: pure.  Cost: linear in the pieces.
#pragma once

#include "dialogue/template/parse.h"

#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// Corrects `right` and `code` of the pieces that depend on others.
void resolve(std::vector<Piece>& pieces);

/// Sum of the pieces' costs.
[[nodiscard]] int total_cost(const std::vector<Piece>& pieces);

}  // namespace fulcrum::dialogue
