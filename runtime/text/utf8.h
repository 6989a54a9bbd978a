// UTF-8 from anywhere, made safe to draw.
//
// Thread: any. Cost: linear.
// Source: The Unicode Standard 15.0, 2022, section 3.9, table 3-7 (well-formed UTF-8).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// More than anybody reads at once; the rest is cut off.
inline constexpr std::size_t kMostCodePoints = 4000;

/// What stands for a byte or a code point that cannot be drawn.
inline constexpr char32_t kReplacement = 0xFFFD;

/// Code points to draw: ill-formed bytes become U+FFFD, tabs a space, line breaks '\n'; other
/// control, zero-width, direction and private characters are left out. At most kMostCodePoints.
[[nodiscard]] std::u32string decode_for_display(std::string_view utf8);

/// Its one to four bytes behind `text`.
void append_utf8(std::string& text, char32_t code_point);

}  // namespace fulcrum::runtime
