// Whole numbers in words, so that "8" and "eight" are the same answer.
//
// Thread: pure functions.  Cost: a few appends.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

inline constexpr long kGreatestNumber = 999'999;  ///< larger ones stay digits

/// 0 to 999 999 in words, one a part: 21 -> {"twenty", "one"}, 105 -> {"one", "hundred", "and", "five"}. Empty outside.
[[nodiscard]] std::vector<std::string> number_words(long number);

/// True for the words that those are made of, but "and".
[[nodiscard]] bool is_number_word(std::string_view word);

}  // namespace fulcrum::dialogue
