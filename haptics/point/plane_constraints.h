// The point nearest to a wish that lies in front of a few planes.
//
//   minimise 1/2 |x - wish|^2  subject to  n_i . x >= offset_i
// Of the Lagrangian 1/2 |x - wish|^2 - sum_i lambda_i (n_i . x - offset_i) the conditions are, with at most three active planes,
//   x = wish + sum_i lambda_i n_i,   n_i . x = offset_i,   lambda_i >= 0  of the active ones;   n_i . x >= offset_i  of the others:
// up to six equations for x and three multipliers. The first two are the system of Zilles and Salisbury; that no plane pulls, the
// third, is how theirs are told active. Every set of one, two and three planes is tried, fewest first, and solved along directions made
// perpendicular one after the other, so that planes nearly parallel keep their accuracy. The problem is convex: the first set that
// meets all four conditions is the answer.
//
// Thread: haptic loop. Cost: bounded, at most 15 sets; no allocation.
// Source: C. B. Zilles, J. K. Salisbury 1995, A constraint-based god-object method for haptic display, IROS; the system by Lagrange
// multipliers. The four conditions are those of Karush, Kuhn and Tucker.
#pragma once

#include "haptics/math/spatial.h"

#include <array>
#include <span>

namespace fulcrum {

/// normal . x >= offset_m.
struct PlaneConstraint {
    Vector3 normal{Vector3::UnitY()};  ///< unit, towards the side that is allowed
    double offset_m = 0.0;             ///< of the plane from the origin, along the normal
};

inline constexpr std::size_t kMaxPlanes =
    4;  ///< three that hold a point, and one that it has just met

struct ConstrainedPoint {
    Vector3 position{Vector3::Zero()};  ///< metres, in the frame of wish and planes
    int n_active = 0;                   ///< 0 to 3
    std::array<int, 3> active{};        ///< indices of the active planes, rising
    std::array<double, 3>
        multiplier{};  ///< metres, of each active plane: how far it holds the point off the wish
    bool feasible = false;  ///< false: no point lies in front of all; position is zero then
};

/// The wish and 0 to kMaxPlanes planes in one frame, all finite. A plane counts as respected up to `slack_m` >= 0.
[[nodiscard]] ConstrainedPoint compute_constrained_point(const Vector3& wish,
                                                         std::span<const PlaneConstraint> planes,
                                                         double slack_m) noexcept;

}  // namespace fulcrum
