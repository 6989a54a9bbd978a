// The power of a short piece of sound by frequency.
//
//   P_k = |sum over n of w[n] x[n] exp(-2 pi i k n / N)|² / sum of w²,   k = 0 … N/2
//   w      Hann's window over kWindow samples, zeros from there to N = kTransform
// The mean over k of white noise is its variance, whatever the window.
//
// Thread: any. Cost: N log2 N complex products, some 10 µs.
// Source: J. Cooley, J. Tukey 1965, An algorithm for the machine calculation of complex Fourier series, Mathematics of Computation 19.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace fulcrum::runtime {

inline constexpr std::size_t kTransform = 512;  ///< N
inline constexpr std::size_t kWindow = 400;     ///< 25 ms at 16 kHz

using PowerSpectrum = std::array<double, kTransform / 2 + 1>;

[[nodiscard]] PowerSpectrum compute_power(std::span<const double, kWindow> x);

}  // namespace fulcrum::runtime
