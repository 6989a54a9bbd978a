// Whether a triangle and a box with edges along the axes have a point in common.
//
// Two convex bodies are apart exactly when their shadows on one of a few lines are: here the box's three axes, the
// triangle's normal, and the nine cross products of an axis and an edge. With the triangle's corners v_i counted from
// the box's middle and half edges h, along the line a:
//   apart when  min_i a.v_i > r  or  max_i a.v_i < -r,   r = sum_k h_k |a_k|
// Every comparison is widened by a bound on what rounding may have changed, so that the answer "apart" is always true:
// what touches in exact arithmetic is never missed. Shapes apart by less than about 1e-14 of their size may count as
// touching.
//
// Thread: any. Cost: 20 to 60 ns.
// Source: T. Akenine-Moller 2001, Fast 3D triangle-box overlap testing, J. Graphics Tools 6(1), section 2 (the thirteen
// lines). The bound on rounding is ours.
#pragma once

#include "haptics/math/spatial.h"

#include <array>

namespace fulcrum {

/// Corners, all in one frame.
using TrianglePoints = std::array<Vector3, 3>;

/// The closed box from `centre - half` to `centre + half`; `half` is 0 or more along each axis. A triangle without area is
/// the segment or the point it has become. False where a number is none.
[[nodiscard]] bool overlaps_box(const TrianglePoints& triangle, const Vector3& centre,
                                const Vector3& half) noexcept;

}  // namespace fulcrum
