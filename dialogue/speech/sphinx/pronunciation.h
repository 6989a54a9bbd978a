// How a word sounds that no dictionary has: what learners make of words by rule.
//
//   goodest, beautifuler      the adjective, then EH S T or ER       "good" + "est"
//   maked, breaked            the verb, then T, D or IH D            by its last sound
//   mans, foots, boxs         the noun, then S, Z or IH Z            likewise
//   hardly, hardness          the word, then L IY, N AH S
// The word is found again behind the rules of spelling: a dropped e (maked, larger), a doubled consonant (bigest, bigger), y for i.
//
// Thread: pure.  Cost: a few look-ups.
// Source: the sounds are ARPAbet's, as the CMU Pronouncing Dictionary writes them; the rules of -s and -ed: Quirk, Greenbaum, Leech and
//   Svartvik 1985, "A Comprehensive Grammar of the English Language", sections 3.5, 3.6 and 5.80.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::dialogue {

/// The sounds of a word in the dictionary, apart by spaces; nothing where it has none.
using LookUp = std::function<std::optional<std::string>(std::string_view)>;

/// The sounds of `word`, lower case: the dictionary's, or by the rules above; nothing where neither knows it.
[[nodiscard]] std::optional<std::string> pronounce(std::string_view word, const LookUp& look_up);

}  // namespace fulcrum::dialogue
