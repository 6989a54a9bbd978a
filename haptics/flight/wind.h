// The wind over flat land: stronger higher up, and gusty.
//
//   U(h) = U_10 ln((h + z) / z) / ln((10 m + z) / z)       mean, z the roughness of the ground; none at the ground
//   W    = (U(h) + u) d + v c + w up                        d downwind, c = up x d across
// The gusts u, v, w are Dryden's, carried past at U(h); with L / U their time, s their strength:
//   S_u = s_u^2 2 L_u / (pi U) 1 / (1 + (L_u k)^2)          k = omega / U
//   S_v = s_v^2 L_v / (pi U) (1 + 3 (L_v k)^2) / (1 + (L_v k)^2)^2,  likewise w
//   L_w = h,  L_u = L_v = h / (0.177 + 0.000823 h)^1.2,  s_w = 0.1 U_6,  s_u = s_v = s_w / (0.177 + 0.000823 h)^0.4
//   (h in feet, 10 to 1000; U_6 at 20 feet), all times `gustiness`
// White noise through filters of first and second order, stepped exactly: with a = exp(-U dt / L), r = U dt / L
//   p' = a p + n_1,  q' = a q + r a p + n_2,   u = s p,   v = s/sqrt(2) (sqrt(3) p + (1 - sqrt(3)) q)
// n has just the covariance that keeps <p^2> = 1, <p q> = <q^2> = 1/2, so any dt has the right strength.
// Everywhere the same gust at one time: a kite is smaller than a gust is long.
//
// Thread: that of the step. Cost: 30 ns a place, 0.3 us a step of the gusts. No allocation. Same seed, same gusts.
// Source: MIL-F-8785C 1980, Flying qualities of piloted airplanes, 3.7.1.2 (Dryden form), 3.7.3.4 (low altitude), profile as in
// 3.7.3.2. Roughness: J. Wieringa 1992, Updating the Davenport roughness classification.
#pragma once

#include "haptics/base/error.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstdint>

namespace fulcrum {

inline constexpr double kFastestWind_m_per_s = 60.0;

/// Fixed at load.
struct WindSettings {
    double speed_m_per_s = 6.0;            ///< U_10, at 10 metres; 0 to kFastestWind_m_per_s
    Vector3 downwind_W{Vector3::UnitX()};  ///< unit, level
    double roughness_m = 0.03;  ///< of short grass 0.03, of a lake 0.0002, of a suburb 1; 1e-5 to 5
    double gustiness = 0.0;     ///< 0: a steady wind; 1: as the specification; 0 to 4
    double ground_m = 0.0;      ///< where the land lies
    std::uint64_t seed = 1;
};

/// The gusts' filters.
struct GustState {
    Vector3 first{Vector3::Zero()};       ///< p of u, v, w
    Vector3 second{Vector3::Zero()};      ///< q; unused of u
    Vector3 velocity_W{Vector3::Zero()};  ///< m/s, the gust itself
    std::uint64_t n_drawn = 0;            ///< random numbers so far
};

/// Strength and length of the gusts at a height.
struct GustScale {
    Vector3 strength_m_per_s{Vector3::Zero()};  ///< s of u, v, w
    Vector3 length_m{Vector3::Ones()};          ///< L
};

/// Refuses settings outside the ranges above, a direction that is not level or not of length one, NaN.
[[nodiscard]] Expected<void> validate(const WindSettings& settings);

/// U at a height above the ground; 0 below it.
[[nodiscard]] double compute_mean_wind_m_per_s(const WindSettings& settings,
                                               double height_m) noexcept;
/// How the gusts are there.
[[nodiscard]] GustScale compute_gust_scale(const WindSettings& settings, double height_m) noexcept;
/// Moves the gusts on by `dt_s` as they are at a height. A dt that is not above 0 and finite, or no gustiness, moves nothing.
void step_gusts(const WindSettings& settings, double height_m, double dt_s,
                GustState& gusts) noexcept;
/// The air's velocity at a place, m/s.
[[nodiscard]] Vector3 compute_wind_W(const WindSettings& settings, const GustState& gusts,
                                     const Vector3& place_W) noexcept;

}  // namespace fulcrum
