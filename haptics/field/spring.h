// A spring between the tool and a point of the scene, with a damper.
//
//   F = -k (x - x_anchor) - b v        k newtons a metre, b newton seconds a metre, both >= 0
// Thread: any. Cost: a few nanoseconds. Source: Hooke's law; the damper keeps a device from ringing
// on it.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

/// The spring alone: newtons on the tool at `position_W` metres.
[[nodiscard]] inline Vector3 compute_spring_pull(const Vector3& position_W, const Vector3& anchor_W,
                                                 double stiffness_N_per_m) noexcept {
    return -stiffness_N_per_m * (position_W - anchor_W);
}

/// Force in newtons on the tool at `position_W` metres moving with `velocity_W` metres per second.
[[nodiscard]] inline Vector3 compute_spring_force(const Vector3& position_W,
                                                  const Vector3& velocity_W,
                                                  const Vector3& anchor_W, double stiffness_N_per_m,
                                                  double damping_Ns_per_m) noexcept {
    return compute_spring_pull(position_W, anchor_W, stiffness_N_per_m) -
           damping_Ns_per_m * velocity_W;
}

}  // namespace fulcrum
