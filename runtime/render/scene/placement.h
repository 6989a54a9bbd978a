// Where a model stands in the world, checked for drawing.
//
//   p_W = position + R (scale * p_M);  n_W = R (n_M / scale)
//
// Thread: any; values. Cost: a few dozen multiplications.
#pragma once

#include "haptics/math/spatial.h"

#include <optional>

namespace fulcrum::runtime {

/// A model's transform in single precision.
struct Placement {
    Matrix4f world_from_model{Matrix4f::Identity()};
    Matrix3f normal_from_model{Matrix3f::Identity()};  ///< result not of unit length
    bool mirrored = false;  ///< turns left into right, and fronts into backs
};

/// The transform of a pose and a stretch along the model's axes. Nothing when a number is not
/// finite, the place is beyond 1e6 m, the rotation has no length, or a stretch is outside 1e-6 to
/// 1e6: such a thing cannot be drawn.
[[nodiscard]] std::optional<Placement> place(const Pose& pose_W, const Vector3& scale);

/// A ball around a placed box.
struct Bounds {
    Vector3 centre_W{Vector3::Zero()};
    double radius_m = 0.0;            ///< of the longest half side
    double enclosing_radius_m = 0.0;  ///< holds the whole box
    double half_width_m = 0.0;        ///< the largest half extent along X or Z, in the world
    double lowest_m = 0.0;            ///< the least height of the box, in the world
};

/// Bounds of a box given by two corners in model space.
[[nodiscard]] Bounds bounds_of(const Placement& placement, const Vector3f& lowest,
                               const Vector3f& highest);

}  // namespace fulcrum::runtime
