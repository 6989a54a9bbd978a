// The same sound, slower and lower: what a smaller throat said sounds as a larger one would have said it.
//
//   y[n] = sum over k of x[k] L(n / a - k),   L(t) = sinc(t) sinc(t / kZeros) where |t| < kZeros, a the factor
// A throat that is a times shorter has formants a times higher, and all of them come down by a. The words take a times longer too, which
// disturbs a model of sounds far less than formants in the wrong place do.
//
// Thread: pure. Cost: 2 kZeros products a sample, some 10 ms a second.
// Source: E. Eide, H. Gish 1996, A parametric approach to vocal tract length normalization, ICASSP, section 2 (formants by length);
//   C. Duchon 1979, Lanczos filtering in one and two dimensions, Journal of Applied Meteorology 18(8) (L).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum::dialogue {

inline constexpr double kMostStretch = 2.0;

/// `sound` slower by `factor`, 1 to kMostStretch; what is beyond is taken as the nearest of these. With 1 it is the same.
[[nodiscard]] std::vector<std::int16_t> stretch(std::span<const std::int16_t> sound, double factor);

}  // namespace fulcrum::dialogue
