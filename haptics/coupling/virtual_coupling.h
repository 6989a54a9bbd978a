// The spring between hand and proxy, which may saturate. Its damper stands in contact_damper.h.
//
//   F = f(|d|) d/|d|,   d = x_proxy - x_hand: the force on the hand;
//   f(s) = k s                                for s <= s1 (linear)
//          cubic Hermite from (s1, k s1), slope k, to (s2, F_max), slope 0
//          F_max                              for s >= s2 (constant);   f is C1 and never falls.
// The cubic rises everywhere if and only if its first slope is at most three
// times its secant (F. N. Fritsch, R. E. Carlson 1980, Monotone piecewise cubic interpolation, SIAM
// J. Numer. Anal. 17(2)).
//
// Thread: haptic loop. Cost: some 20 operations, no allocation.
// Source: M. Otaduy, M. Lin 2005/2006 (virtual coupling with a force that saturates); M. Wan, W.
// McNeely 2003, Quasi-static approximation for 6 degrees-of-freedom haptic rendering.
#pragma once

#include "haptics/base/error.h"
#include "haptics/coupling/coupling_settings.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

/// Refuses settings outside the ranges named at each field, NaN included, and a saturating part
/// that would fall.
[[nodiscard]] Expected<void> validate(const CouplingSettings& settings);

/// The same spring with at most `force_N`, linear up to `linear_range_m`, and nowhere steeper than it was, so that what is stable stays so:
/// a blend of width w = 3 (F - k s1) / 2 k, whose slope is k (1 - u^2). Wants k s1 < F.
[[nodiscard]] CouplingSettings saturate(const CouplingSettings& settings, double linear_range_m,
                                        double force_N) noexcept;

/// The spring's force in newtons at a stretch of `stretch_m` >= 0.
[[nodiscard]] double compute_spring_force_N(const CouplingSettings& settings,
                                            double stretch_m) noexcept;

/// df/ds of the spring at a stretch of `stretch_m` >= 0, in N/m; at a seam both sides agree.
[[nodiscard]] double compute_spring_slope_N_per_m(const CouplingSettings& settings,
                                                  double stretch_m) noexcept;
/// What the spring has stored at a stretch of `stretch_m` >= 0: joules (world metres), the integral of
/// its force.
[[nodiscard]] double compute_spring_energy_J(const CouplingSettings& settings,
                                             double stretch_m) noexcept;
/// The spring's force on the hand alone, world frame, newtons.
[[nodiscard]] Vector3 compute_coupling_spring(const CouplingSettings& settings,
                                              const Vector3& proxy_W,
                                              const Vector3& hand_W) noexcept;

}  // namespace fulcrum
