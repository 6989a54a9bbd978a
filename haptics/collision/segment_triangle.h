// Where a segment meets a triangle, decided by exact signs.
//
// The segment p q meets the triangle a b c when p and q do not lie strictly on one side of its plane and the three
// orientations (p, q, a, b), (p, q, b, c), (p, q, c, a) are not of different signs. Ends, edges and corners belong to
// the triangle, and because the signs are exact, a segment that passes between neighbours meets at least one of them:
// a path of segments without a meeting never crosses a closed surface.
//
// Thread: any. Cost: about 10 ns when the plane decides, some microseconds for points coplanar to within rounding.
// Source: the signs of tetrahedra as in Shewchuk 1997 (see orientation.h); t from the heights over the plane.
#pragma once

#include "haptics/math/orientation.h"
#include "haptics/math/spatial.h"

#include <cmath>
#include <cstdint>

namespace fulcrum {

/// A triangle with its normal at hand. Body frame.
struct PreparedTriangle {
    Vector3 a, b, c;
    Vector3 doubled_area;  ///< (b - a) x (c - a): along the front's normal, twice the area long
    double error_per_m =
        0.0;  ///< bound on the error of a height times twice the area, for each metre of distance
    std::int32_t index = -1;
};

/// A meeting at from + t (to - from). Two words long, so that it is passed on in registers.
struct SegmentHit {
    double t = 2.0;  ///< 0 to 1; 2 when there is none
    std::int32_t triangle = -1;
    /// +1 when `from` lies on the front's side, -1 behind; 0 when both ends lie in the plane.
    std::int32_t side = 0;

    [[nodiscard]] bool found() const noexcept { return triangle >= 0; }
    /// Of two meetings the nearer, of equally near ones that of the lower triangle.
    [[nodiscard]] bool is_before(const SegmentHit& other) const noexcept {
        return t < other.t || (t == other.t && triangle < other.triangle);
    }
};

[[nodiscard]] inline PreparedTriangle prepare_triangle(const Vector3& a, const Vector3& b,
                                                       const Vector3& c,
                                                       std::int32_t index) noexcept {
    const Vector3 ab = b - a;
    const Vector3 ac = c - a;
    return {
        a,    b, c, ab.cross(ac), kDeterminantError * largest_component(ab) * largest_component(ac),
        index};
}

/// The rest of `meet` for a segment whose ends lie on different sides, or in the plane. `side_from` and `side_to` are
/// exact signs, the heights their rounded measures.
[[nodiscard]] SegmentHit meet_in_plane(const PreparedTriangle& triangle, const Vector3& from,
                                       const Vector3& to, double height_from, double height_to,
                                       int side_from, int side_to) noexcept;

/// Where the segment meets the triangle, if anywhere.
[[nodiscard]] inline SegmentHit meet(const PreparedTriangle& triangle, const Vector3& from,
                                     const Vector3& to) noexcept {
    const Vector3 from_a = from - triangle.a;
    const Vector3 to_a = to - triangle.a;
    const double height_from = triangle.doubled_area.dot(from_a);
    const double height_to = triangle.doubled_area.dot(to_a);
    const double error_from = triangle.error_per_m * largest_component(from_a);
    const double error_to = triangle.error_per_m * largest_component(to_a);
    if ((height_from > error_from && height_to > error_to) ||
        (height_from < -error_from && height_to < -error_to)) {
        return {};
    }
    const auto sign = [&triangle](double height, double error, const Vector3& point) noexcept {
        if (std::abs(height) > error) {
            return height > 0.0 ? 1 : -1;
        }
        return orientation_exact(triangle.a, triangle.b, triangle.c, point);
    };
    const int side_from = sign(height_from, error_from, from);
    const int side_to = sign(height_to, error_to, to);
    if (side_from * side_to > 0) {
        return {};
    }
    return meet_in_plane(triangle, from, to, height_from, height_to, side_from, side_to);
}

}  // namespace fulcrum
