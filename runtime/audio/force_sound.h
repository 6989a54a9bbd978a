// How a force sounds to somebody who cannot feel it.
//
//   loudness   g(F) = F / (F + F_half)      0 at 0 N, half at F_half, never above 1
//   pitch      2^(F / F_octave)             an octave every 5 N, two at most
//   both follow the commanded force with a time constant, so that nothing clicks.
#pragma once

#include <algorithm>
#include <cmath>

namespace fulcrum::runtime {

inline constexpr double kForceHalf_N = 2.0;
inline constexpr double kForceOctave_N = 5.0;
inline constexpr double kForceFollow_s = 0.04;

/// Newtons that count: not finite or negative is 0, above 10 is 10.
[[nodiscard]] inline double audible_force_N(double force_N) noexcept {
    return std::isfinite(force_N) ? std::clamp(force_N, 0.0, 10.0) : 0.0;
}

/// Linear amplitude, 0 to 1, grows with the force.
[[nodiscard]] inline double force_gain(double force_N) noexcept {
    const double F = audible_force_N(force_N);
    return F / (F + kForceHalf_N);
}

/// Pitch factor, 1 to 4, grows with the force.
[[nodiscard]] inline double force_pitch(double force_N) noexcept {
    return std::exp2(audible_force_N(force_N) / kForceOctave_N);
}

/// One step of first-order following: exact for a target held over `dt_s`.
[[nodiscard]] inline double follow(double value, double target, double dt_s) noexcept {
    const double dt = std::isfinite(dt_s) ? std::max(dt_s, 0.0) : 0.0;
    return target + (value - target) * std::exp(-dt / kForceFollow_s);
}

}  // namespace fulcrum::runtime
