// A spring between the tool and a point of the scene. What keeps a device from ringing on it is viscosity.h.
//
//   F = -k (x - x_anchor)        k newtons a metre, >= 0
// Thread: any. Cost: a few nanoseconds. Source: Hooke's law.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

/// Newtons on the tool at `position_W` metres.
[[nodiscard]] inline Vector3 compute_spring_pull(const Vector3& position_W, const Vector3& anchor_W,
                                                 double stiffness_N_per_m) noexcept {
    return -stiffness_N_per_m * (position_W - anchor_W);
}

}  // namespace fulcrum
