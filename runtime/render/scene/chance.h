// A number by chance that is the same in every run: pictures can be drawn again.
//
// Source: T. Wang, Integer Hash Function, 2007.
#pragma once

#include <cstdint>

namespace fulcrum::runtime {

/// 0 to 1, another one for each i.
[[nodiscard]] constexpr double chance(std::uint32_t i) {
    i = (i ^ 61U) ^ (i >> 16U);
    i *= 9U;
    i ^= i >> 4U;
    i *= 0x27d4eb2dU;
    i ^= i >> 15U;
    return static_cast<double>(i) / 4294967296.0;
}

}  // namespace fulcrum::runtime
