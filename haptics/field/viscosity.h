// A thick liquid: a force against the motion.
//
//   F = -b v        b newton seconds a metre, >= 0
// Thread: any. Cost: a few nanoseconds. Source: linear (Stokes) drag.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

/// Force in newtons on a tool that moves with `velocity_W` metres per second. Its power F v is
/// never positive.
[[nodiscard]] inline Vector3 compute_viscous_force(const Vector3& velocity_W,
                                                   double damping_Ns_per_m) noexcept {
    return -damping_Ns_per_m * velocity_W;
}

}  // namespace fulcrum
