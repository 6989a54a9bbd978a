// Determiners of which a noun has one at most: a, an, the, this, my, its and their like.
//
// Thread: pure function.  Cost: a table look-up.
// Source: Quirk, Greenbaum, Leech and Svartvik 1985, "A Comprehensive Grammar of the English Language", 5.11 to 5.14
//   (central determiners).
#pragma once

#include <string_view>

namespace fulcrum::dialogue {

/// True for a word in lower case that stands before a noun with no other of its kind: "the a moon" is wrong.
[[nodiscard]] bool is_sole_determiner(std::string_view word);

}  // namespace fulcrum::dialogue
