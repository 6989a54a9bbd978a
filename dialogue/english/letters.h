// Letters and words at the level of spelling: vowels, case, the distance between two words.
//
// Thread: pure functions.  Cost: `edit_distance` is one table of (|a|+1) x (|b|+1) cells.
// Source: Damerau 1964, "A technique for computer detection and correction of spelling errors", Communications of the ACM
//   7(3); the form with adjacent transpositions only (optimal string alignment).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fulcrum::dialogue {

/// a, e, i, o, u in lower case.
[[nodiscard]] constexpr bool is_vowel_letter(char letter) {
    return letter == 'a' || letter == 'e' || letter == 'i' || letter == 'o' || letter == 'u';
}

/// Capital letters small, byte for byte: a letter whose small one takes another number of bytes stays, and so do bytes that are no UTF-8.
[[nodiscard]] std::string lower_case(std::string_view text);

/// The first letter in upper case when it is ASCII: "a watermelon" -> "A watermelon".
[[nodiscard]] std::string sentence_case(std::string_view text);

/// The same of every sentence of `text`, also inside *asterisks*; and "i" alone is "I".
[[nodiscard]] std::string sentences_case(std::string_view text);
/// The same, with a stop at its end where it has none.
[[nodiscard]] std::string as_sentences(std::string_view text);

/// Smallest number of letters inserted, deleted, replaced or swapped with their neighbour that turns `a` into `b`.
/// Words longer than 32 bytes are at distance 33.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// Distance that still counts as a slip of the pen for a word of `length` letters: 0 below 3, 1 below 8, then 2.
[[nodiscard]] constexpr int allowed_slip(std::size_t length) {
    return length < 3 ? 0 : (length < 8 ? 1 : 2);
}

}  // namespace fulcrum::dialogue
