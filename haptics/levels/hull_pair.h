// How far two convex hulls are apart, where they are nearest, and a bound from below that ends the search early.
//
// The difference D of the hulls, all a - b, is convex; its point v nearest to the origin is the shortest way between them. It is sought in
// simplices of up to four support points w = a - b: nearest point of the simplex, then the support point farthest back along v. With
// n = v / |v| all of D lies beyond n . w, so
//   n . w <= distance <= |v|
// and the search ends where both agree, or where the bound from below already says "farther than asked for". The nearest points are the same
// blend of the simplex's a and b that gives v. A small hull is asked point by point; a large one by climbing from corner to neighbour,
// which on a convex body ends at the farthest.
// Slivers, such as corners of a long flat side make, may mislead the nearest point by regions: where the search gets stuck, or finds a corner that
// it has, and both bounds are apart, it goes on with the nearest of all the simplex's parts, one by one.
//
// Thread: any. Cost: 3 to 8 support pairs of some 20 ns each for hulls of ten points; no allocation.
// Source: E. G. Gilbert, D. W. Johnson, S. S. Keerthi 1988, A fast procedure for computing the distance between complex objects in
// three-dimensional space, IEEE J. Robotics and Automation 4(2); the regions of a triangle as in C. Ericson 2005, Real-Time Collision
// Detection, section 5.1.5; climbing: S. Cameron 1997, Enhancing GJK, ICRA.
#pragma once

#include "haptics/math/spatial.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace fulcrum {

/// A hull's corners, and where there are many, each one's neighbours: those of corner i are links[first_link[i]] to before
/// links[first_link[i + 1]].
struct HullView {
    std::span<const Vector3> points{};
    std::span<const std::int32_t> first_link{};  ///< empty: it is asked point by point
    std::span<const std::int32_t> links{};

    /// The corner farthest along a direction.
    [[nodiscard]] const Vector3& find_support(const Vector3& direction) const noexcept {
        std::int32_t at = 0;
        return find_support(direction, at);
    }
    /// `at`: where a climb begins, and which corner it was.
    [[nodiscard]] const Vector3& find_support(const Vector3& direction,
                                              std::int32_t& at) const noexcept;
};

/// From which number of corners on climbing is worth its links.
inline constexpr std::size_t kClimbFrom = 64;

/// The shortest way between two hulls, in the first one's frame.
struct HullPair {
    Vector3 on_first{Vector3::Zero()};
    Vector3 on_second{Vector3::Zero()};
    Vector3 normal{
        Vector3::
            UnitY()};  ///< unit, from the first to the second; where they meet that of the last bound
    double gap_m = 0.0;    ///< |v|: not less than the distance
    double least_m = 0.0;  ///< not more than the distance, 0 where they meet
    bool is_far = false;   ///< ended early: farther apart than asked for, the points are not told
    bool is_held = false;  ///< they meet, and `held` are points of D that span a volume round 0
    std::array<Vector3, 4> held;  ///< else whatever was there
};

/// Where climbs begin, and where they ended: a search that is repeated begins there.
struct HullCorners {
    std::int32_t first = 0;
    std::int32_t second = 0;
};

/// `start`: any vector that points from the first to the second, not zero: the last normal is best. Ends early where the distance is above
/// `enough_m`.
[[nodiscard]] HullPair find_hull_pair(
    const HullView& first, const HullView& second, const Matrix3& turn, const Vector3& shift,
    const Vector3& start, double enough_m = std::numeric_limits<double>::infinity()) noexcept;
[[nodiscard]] HullPair find_hull_pair(const HullView& first, const HullView& second,
                                      const Matrix3& turn, const Vector3& shift,
                                      const Vector3& start, double enough_m,
                                      HullCorners& at) noexcept;

/// How far apart they are along a unit vector `n` from the first to the second: the second's lowest less the first's highest. Below 0: by so
/// much they overlap along it.
[[nodiscard]] double measure_along(const HullView& first, const HullView& second,
                                   const Matrix3& turn, const Vector3& shift,
                                   const Vector3& normal) noexcept;

/// A point's nearest in a hull. `gap_m` 0 where it lies inside. `start` and `enough_m` as for two hulls.
[[nodiscard]] HullPair find_nearest_in_hull(
    const HullView& hull, const Vector3& point, const Vector3& start = Vector3::Zero(),
    double enough_m = std::numeric_limits<double>::infinity(), std::int32_t at = 0) noexcept;

}  // namespace fulcrum
