// Which way the characters of a text run, where some are written from right to left.
//
//   A character's level is even from left to right, odd from right to left, and deeper where one
//   stands in the other: digits in Hebrew, Hebrew in English.
//
// Thread: any. Cost: linear; a text without letters from right to left is only looked through.
// Source: Unicode Standard Annex 9 (the bidirectional algorithm), rules P2-P3, X1-I2, L2; by FriBidi 1.0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

struct Directions {
    std::vector<std::uint8_t> levels;  ///< one a character
    std::uint8_t base = 0;             ///< of the whole: that of its first letter
};

/// Of a text without line breaks.
[[nodiscard]] Directions find_directions(std::u32string_view text);

/// In which order things with these levels stand in a line, from left to right (rule L2).
[[nodiscard]] std::vector<std::size_t> order_in_line(const std::vector<std::uint8_t>& levels);

}  // namespace fulcrum::runtime
