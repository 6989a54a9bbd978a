// Why a Touch may not be held now, and what people are told of it. A trouble is the library's own number: an error, or how its
// calibration stands; 0 is none.
//
// Thread: any. Cost: a look at a short list.
// Source: OpenHaptics 3.0, API Reference Manual, appendix A.
#pragma once

#include <cstdint>
#include <string>

namespace fulcrum::runtime {

/// What it told is no pose. No number of the library's.
inline constexpr std::uint32_t kHdNoNumber = 1;
/// Its loop has stopped. Likewise.
inline constexpr std::uint32_t kHdStandsStill = 2;

/// How long there is no force after an error, seconds: warm motors cool for longer.
[[nodiscard]] double rest_after_s(std::uint32_t trouble) noexcept;
/// A sentence: what is, and what to do. Of an error that has none here, its number.
[[nodiscard]] std::string words_of_hd(std::uint32_t trouble);

}  // namespace fulcrum::runtime
