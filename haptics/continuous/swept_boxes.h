// Two oriented boxes, one of them on its way over a piece of time: the test of mesh_sweep.h.
//
// Thread: any. Cost: some 60 ns.
#pragma once

#include "haptics/continuous/in_between_motion.h"
#include "haptics/geometry/obb_tree.h"

namespace fulcrum {

/// A piece of time and where the moving body is in its middle.
struct TimePiece {
    double begin = 0.0;
    double end = 1.0;
    double half = 0.5;
    Matrix3 turn{Matrix3::Identity()};  ///< R_AB
    Vector3 pivot_A{Vector3::Zero()};
    Vector3 velocity_A{Vector3::Zero()};  ///< of the pivot
    Vector3 spin_A{Vector3::Zero()};      ///< radians for the whole way
    double angle_rad = 0.0;               ///< of the whole way

    [[nodiscard]] static TimePiece of(const InBetweenMotion& motion, double begin,
                                      double end) noexcept;
};

struct SweptBoxes {
    bool may_touch = true;
    bool is_mostly_motion = false;  ///< the motion is larger than either box
};

/// May they come within `near_m` of each other? Never false when they do.
[[nodiscard]] SweptBoxes look_at_boxes(const OrientedBox& fixed, const OrientedBox& moving,
                                       const Vector3& pivot_B, const TimePiece& piece,
                                       double near_m) noexcept;

}  // namespace fulcrum
