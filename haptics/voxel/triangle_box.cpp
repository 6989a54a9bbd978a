#include "haptics/voxel/triangle_box.h"

#include <algorithm>
#include <limits>

namespace fulcrum {
namespace {

// A shadow is a sum of at most three products of differences: each of the seven roundings is half of this at most, of a number
// no larger than the bound's factors.
constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();

// At least the largest component; unlike a maximum, a sum keeps what is no number.
double measure(const Vector3& v) noexcept {
    return v.cwiseAbs().sum();
}

// The corners as the box's middle sees them, and how far rounding may have moved any of them.
struct Seen {
    TrianglePoints corners;
    Vector3 half;
    double size_m = 0.0;  // of the numbers that went into a corner
};

bool is_apart_along(const Seen& seen, const Vector3& line) noexcept {
    const double a = line.dot(seen.corners[0]);
    const double b = line.dot(seen.corners[1]);
    const double c = line.dot(seen.corners[2]);
    const double reach = seen.half.dot(line.cwiseAbs()) + kRounding * measure(line) * seen.size_m;
    return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

// The lines that an edge makes with the three axes: (0, -z, y), (z, 0, -x), (-y, x, 0).
bool is_apart_by_edge(const Seen& seen, const Vector3& edge) noexcept {
    return is_apart_along(seen, {0.0, -edge.z(), edge.y()}) ||
           is_apart_along(seen, {edge.z(), 0.0, -edge.x()}) ||
           is_apart_along(seen, {-edge.y(), edge.x(), 0.0});
}

// The plane's normal is itself rounded: its error is that of products of two edges, whatever is left of them.
bool is_apart_by_plane(const Seen& seen, const Vector3& ab, const Vector3& ac) noexcept {
    const Vector3 normal = ab.cross(ac);
    const double height = normal.dot(seen.corners[0]);
    const double error = kRounding * measure(ab) * measure(ac) * seen.size_m;
    return std::abs(height) > seen.half.dot(normal.cwiseAbs()) + 2.0 * error;
}

}  // namespace

bool overlaps_box(const TrianglePoints& triangle, const Vector3& centre,
                  const Vector3& half) noexcept {
    Seen seen{{triangle[0] - centre, triangle[1] - centre, triangle[2] - centre}, half, 0.0};
    seen.size_m = measure(centre) + measure(half);
    for (const Vector3& corner : triangle) {
        seen.size_m += measure(corner);
    }
    if (!(seen.size_m < std::numeric_limits<double>::infinity())) {
        return false;
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (is_apart_along(seen, Vector3::Unit(axis))) {
            return false;
        }
    }
    const Vector3 ab = seen.corners[1] - seen.corners[0];
    const Vector3 bc = seen.corners[2] - seen.corners[1];
    const Vector3 ca = seen.corners[0] - seen.corners[2];
    return !is_apart_by_edge(seen, ab) && !is_apart_by_edge(seen, bc) &&
           !is_apart_by_edge(seen, ca) && !is_apart_by_plane(seen, ab, -ca);
}

}  // namespace fulcrum
