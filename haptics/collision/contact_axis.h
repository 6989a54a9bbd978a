// The direction along which two convex bodies touch, and how far apart they are along it.
//
//   gap(n) = n . (a_low - b_high)    a_low, b_high: the first body's point lowest, the second's highest along n
// n is the unit vector that makes the gap greatest: the way of least translation where they overlap, the shortest way where they are apart.
//   two boxes           15 candidates: three faces' normals each, nine products of edges. Exact where they overlap; where they are apart the
//                       greatest of these gaps, which is below the distance where corner meets corner
//   with a sphere       from the closed form of a point's distance (shape_gap.h)
//   with a half space   its own normal
//   others              distance of the cores (convex_gap.h) where those are apart, least translation (convex_depth.h) where they meet
// Of nearly equal directions a face's normal is taken, and before all the one of last time: another must be better by `kPrefer` times the
// smaller body's size. So n does not tremble with the bodies, and identical aligned cubes keep the same one. The gap told may be less
// than the greatest by twice that.
//
// Thread: any. Cost: two boxes 0.1 us, with a sphere some ten ns, others 0.3 to 5 us; no allocation.
// Source: S. Gottschalk, M. Lin, D. Manocha 1996, OBBTree, SIGGRAPH: 15 axes; G. van den Bergen 2001, see convex_depth.h.
#pragma once

#include "haptics/collision/contact_shape.h"

#include <cstdint>

namespace fulcrum {

/// A shape and where it is; axes W, the origin common to both bodies of a pair.
struct PlacedShape {
    const ContactShape* shape = nullptr;
    Matrix3 turn_WB{Matrix3::Identity()};
    Vector3 place{Vector3::Zero()};

    /// The core's farthest point.
    [[nodiscard]] Vector3 find_support(const Vector3& direction_W) const noexcept {
        return place + turn_WB * shape->core.find_support(turn_WB.transpose() * direction_W);
    }
};

struct ContactAxis {
    Vector3 normal_W{Vector3::UnitY()};  ///< from the second to the first
    double gap_m = 0.0;                  ///< below 0: overlap
    /// Which it is, for the next time: 1 + face of the first, -1 - face of the second, 0 none of them; of two boxes 1000 + pair of edges.
    std::int32_t which = 0;
};

/// Of the size: what another direction must be better by.
inline constexpr double kPrefer = 1.0e-4;

/// `margin_m`: a gap above it may be told as any other above it. `last` is `which` of the last time, 0 at first.
[[nodiscard]] ContactAxis find_contact_axis(const PlacedShape& first, const PlacedShape& second,
                                            double margin_m, std::int32_t last) noexcept;

}  // namespace fulcrum
