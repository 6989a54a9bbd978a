// Where on a texture a point of a body lies, without any coordinates of the body's own: three projections along its axes.
//
// Seen along the body's x axis the texture's (u, v) are (z, y), along y (x, z), along z (x, y): v is up on the sides. Which
// view counts how much is said by the surface's normal:
//   w_a = max(|n_a| - 1/2, 0),   over their sum
// A face within 30 degrees of an axis has one view; between 30 and 60 two are blended. A slope is drawn out by the projection,
// by 1 / |n_a| at most 1.73. The blend's own slope is not felt.
//
// Thread: any. Cost: some ten operations.
#pragma once

#include "haptics/math/spatial.h"
#include "haptics/surface/texture.h"

#include <array>
#include <cstddef>

namespace fulcrum {

/// The axes that are u and v in the view along each axis.
inline constexpr std::array<std::array<Index, 2>, 3> kViewAxes{{{2, 1}, {0, 2}, {0, 1}}};

/// How much each view counts; their sum is 1. `normal_B` is a unit vector.
[[nodiscard]] inline Vector3 compute_view_weights(const Vector3& normal_B) noexcept {
    const Vector3 weights = (normal_B.cwiseAbs() - Vector3::Constant(0.5)).cwiseMax(0.0);
    return weights / weights.sum();
}

/// A vector of the body seen along an axis.
[[nodiscard]] inline SurfaceVector project_on_view(std::size_t axis, const Vector3& v_B) noexcept {
    return {v_B[kViewAxes[axis][0]], v_B[kViewAxes[axis][1]]};
}

/// What a texture adds to a contact, for each newton a metre of the coupling, in the body's frame.
struct BodyOffset {
    Vector3 offset_B_m{Vector3::Zero()};
    SurfaceVector place{};  ///< in the view that counts most
    double height_m = 0.0;
};

/// The texture felt at `place_B` under a contact with the unit normal `normal_B`: along the surface all of it, along the normal
/// what the law says. With `stroke_B` the way of a round and `depth_m` as in texture.h.
[[nodiscard]] BodyOffset feel_on_body(const Texture& texture, const Vector3& place_B,
                                      const Vector3& stroke_B, const Vector3& normal_B,
                                      double depth_m) noexcept;

}  // namespace fulcrum
