// How far a point is from a triangle, and in which direction.
//
// With p = point - a and the foot a + v ab + w ac in the triangle's plane: inside (v, w >= 0, v + w <= 1) the distance is the height; else
// the nearest point lies on one of the edges that the foot is beyond. Both faces are alike.
//
// Thread: any. Cost: 30 to 60 operations.
#pragma once

#include "haptics/collision/segment_query.h"
#include "haptics/math/spatial.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fulcrum {

/// A triangle with all at hand that its distance asks for. Body frame.
struct TriangleForGap {
    Vector3 a, ab, ac;
    Vector3 normal;  ///< unit, along the front's
    double lowest_m = 0.0,
           highest_m = 0.0;  ///< its corners along the normal: alike, but for rounding
    double ab_ab = 0.0, ab_ac = 0.0, ac_ac = 0.0;
    double inverse = 0.0;  ///< 1 / |ab x ac|^2; 0 for a sliver, whose edges are all there is to it
    std::int32_t index = -1;

    [[nodiscard]] double highest_along(const Vector3& direction) const noexcept {
        const double beyond_a = std::max(direction.dot(ab), direction.dot(ac));
        return direction.dot(a) + std::max(beyond_a, 0.0);
    }
    [[nodiscard]] Vector3 find_farthest(const Vector3& direction) const noexcept {
        const double beyond_ab_m = direction.dot(ab);
        const double beyond_ac_m = direction.dot(ac);
        return beyond_ab_m > std::max(beyond_ac_m, 0.0) ? Vector3(a + ab)
               : beyond_ac_m > 0.0                      ? Vector3(a + ac)
                                                        : a;
    }
};

/// The part of a triangle that is nearest to a point.
enum class TrianglePart : std::uint8_t { face, ab, ac, bc, corner };

/// Where a point sees the triangle.
struct TriangleGap {
    Vector3 normal_B;  ///< unit, from the nearest point to the point
    double distance_m = 0.0;
    TrianglePart part = TrianglePart::face;
};

[[nodiscard]] inline TriangleForGap prepare_for_gap(const CollisionMesh& mesh,
                                                    std::int32_t triangle) noexcept {
    constexpr double kSliver =
        1.0e-16;  // sine of an angle, squared: below, the plane is mere rounding
    const TriangleCorners& corners = mesh.corners(triangle);
    TriangleForGap t{.a = mesh.vertex_B(corners[0]),
                     .ab = mesh.vertex_B(corners[1]) - mesh.vertex_B(corners[0]),
                     .ac = mesh.vertex_B(corners[2]) - mesh.vertex_B(corners[0]),
                     .normal = Vector3::Zero(),
                     .index = triangle};
    const Vector3 doubled_area = t.ab.cross(t.ac);
    const double square = doubled_area.squaredNorm();
    t.ab_ab = t.ab.squaredNorm();
    t.ab_ac = t.ab.dot(t.ac);
    t.ac_ac = t.ac.squaredNorm();
    t.normal = doubled_area / std::sqrt(square);
    const double a_m = t.normal.dot(t.a);
    const double ab_m = t.normal.dot(t.ab);
    const double ac_m = t.normal.dot(t.ac);
    t.lowest_m = a_m + std::min({ab_m, ac_m, 0.0});
    t.highest_m = a_m + std::max({ab_m, ac_m, 0.0});
    t.inverse = square > kSliver * t.ab_ab * t.ac_ac ? 1.0 / square : 0.0;
    return t;
}

/// From the nearest of the triangle's edges.
[[nodiscard]] TriangleGap find_gap_to_edges(const TriangleForGap& t, const Vector3& from_a, bool ab,
                                            bool ac, bool bc) noexcept;

[[nodiscard]] inline TriangleGap find_triangle_gap(const TriangleForGap& t,
                                                   const Vector3& point_B) noexcept {
    const Vector3 from_a = point_B - t.a;
    const double along_ab = from_a.dot(t.ab);
    const double along_ac = from_a.dot(t.ac);
    const double v = (t.ac_ac * along_ab - t.ab_ac * along_ac) * t.inverse;
    const double w = (t.ab_ab * along_ac - t.ab_ac * along_ab) * t.inverse;
    if (t.inverse == 0.0) {
        return find_gap_to_edges(t, from_a, true, true, true);
    }
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) {
        const double height = t.normal.dot(from_a);
        return {height < 0.0 ? Vector3(-t.normal) : t.normal, std::abs(height)};
    }
    return find_gap_to_edges(t, from_a, w < 0.0, v<0.0, v + w> 1.0);
}

}  // namespace fulcrum
