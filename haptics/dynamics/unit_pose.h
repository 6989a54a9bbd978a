// Poses that come from outside: their quaternions may have any length but none.
//
// Thread: any. Cost: a root.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

/// Whether it says how a body is turned.
[[nodiscard]] inline bool has_turn(const Pose& pose) noexcept {
    const double squared = pose.orientation.squaredNorm();
    return squared > 1.0e-200 && squared < 1.0e200;
}

[[nodiscard]] inline Pose with_unit_turn(const Pose& pose) noexcept {
    Pose unit = pose;
    unit.orientation.normalize();
    return unit;
}

}  // namespace fulcrum
