// UTF-8 from anywhere, made safe to draw.
//
// Thread: any. Cost: linear.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// More than anybody reads at once; the rest is cut off.
inline constexpr std::size_t kMostCodePoints = 4000;

/// Code points to draw: ill-formed bytes become U+FFFD, tabs a space, line breaks '\n'; other
/// control, zero-width, direction and private characters are left out, but for what joins letters or
/// keeps them apart behind one of a script that needs it. At most kMostCodePoints.
[[nodiscard]] std::u32string decode_for_display(std::string_view utf8);

}  // namespace fulcrum::runtime
