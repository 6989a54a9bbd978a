// A pull towards a point that is zero at the point, largest at `range` and gone far away.
//
//   F = -peak (r / range) exp((1 - |r|^2 / range^2) / 2),   r = x - x_anchor
// The derivative of |F| vanishes at |r| = range, where |F| = peak. F = -grad U with
// U = -peak range exp((1 - s^2) / 2), s = |r| / range: smooth everywhere and conservative. Its
// stiffness is largest at the centre: peak sqrt(e) / range.
//
// Thread: any. Cost: one exponential.
// Source: a Gaussian well, chosen for being smooth at both ends where 1/r^2 is not; its gradient.
#pragma once

#include "haptics/math/spatial.h"

#include <cmath>

namespace fulcrum {

/// Force in newtons on the tool at `position_W`; never longer than `peak_force_N`. `range_m` > 0.
[[nodiscard]] inline Vector3 compute_magnet_force(const Vector3& position_W,
                                                  const Vector3& anchor_W, double peak_force_N,
                                                  double range_m) noexcept {
    const Vector3 away = (position_W - anchor_W) / range_m;
    return -peak_force_N * std::exp(0.5 * (1.0 - away.squaredNorm())) * away;
}

}  // namespace fulcrum
