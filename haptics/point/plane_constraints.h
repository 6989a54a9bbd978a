// The point nearest to a wish that lies in front of a few planes.
//
//   minimise 1/2 |x - wish|^2  subject to  n_i . x >= gap_i
// At the solution x = wish + sum_i lambda_i n_i with lambda_i >= 0 and n_i . x = gap_i for at most three active planes:
// the Lagrange system of Zilles and Salisbury. Every set of one, two and three planes is tried, fewest first, and solved
// along directions made perpendicular one after the other, so that planes nearly parallel keep their accuracy; the
// first set whose solution respects the other planes is the answer, for the problem is convex.
//
// Thread: haptic loop. Cost: bounded, at most 15 sets; no allocation.
// Source: C. B. Zilles, J. K. Salisbury 1995, A constraint-based god-object method for haptic display, IROS.
#pragma once

#include "haptics/math/spatial.h"

#include <array>
#include <span>

namespace fulcrum {

/// n . x >= gap, n of unit length.
struct PlaneConstraint {
    Vector3 normal{Vector3::UnitY()};
    double gap_m = 0.0;
};

inline constexpr std::size_t kMaxPlanes = 4;

struct ConstrainedPoint {
    Vector3 position{Vector3::Zero()};
    int n_active = 0;
    std::array<int, 3> active{};         ///< indices of the active planes
    std::array<double, 3> multiplier{};  ///< metres, of each active plane
    bool feasible = false;  ///< false: no point lies in front of all; position is zero then
};

/// At most kMaxPlanes planes. A plane counts as respected up to `slack_m`.
[[nodiscard]] ConstrainedPoint compute_constrained_point(const Vector3& wish,
                                                         std::span<const PlaneConstraint> planes,
                                                         double slack_m) noexcept;

}  // namespace fulcrum
