#include "haptics/levels/level_draft.h"

#include "haptics/geometry/convex_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fulcrum {

namespace {

// Directions spread evenly over the sphere, by the golden angle.
std::array<Vector3, 64> make_directions() {
    std::array<Vector3, 64> directions;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const double y = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / 64.0;
        const double angle = std::numbers::pi * (3.0 - std::sqrt(5.0)) * static_cast<double>(i);
        const double across = std::sqrt(1.0 - y * y);
        directions[i] = {across * std::cos(angle), y, across * std::sin(angle)};
    }
    return directions;
}

}  // namespace

void LevelDraft::take_points(const PieceShape& shape, double slack_m) {
    if (shape.is_flat(slack_m)) {
        points = find_flat_hull(shape.corners, shape.planes.front().normal);
        return;
    }
    points = shape.corners;
    if (points.size() < kClimbFrom) {
        return;
    }
    const Expected<TriangleMesh> hull = make_convex_hull(shape.corners);
    if (!hull) {
        return;
    }
    points = hull->vertices_B();
    std::vector<std::vector<std::int32_t>> beside(points.size());
    for (const TriangleCorners& triangle : hull->triangles()) {
        for (std::size_t i = 0; i < 3; ++i) {
            beside[static_cast<std::size_t>(triangle[i])].push_back(triangle[(i + 1) % 3]);
        }
    }
    for (const auto& corner : beside) {
        first_link.push_back(static_cast<std::int32_t>(links.size()));
        links.insert(links.end(), corner.begin(), corner.end());
    }
    first_link.push_back(static_cast<std::int32_t>(links.size()));
}

void LevelDraft::take_outermost(const std::vector<Vector3>& from) {
    static const std::array<Vector3, 64> kDirections = make_directions();
    std::vector<Vector3> picked;
    for (const Vector3& direction : kDirections) {
        const Vector3& farthest = HullView{.points = from}.find_support(direction);
        if (std::ranges::find(picked, farthest) == picked.end()) {
            picked.push_back(farthest);
        }
    }
    points = std::move(picked);
    first_link.clear();
    links.clear();
    node.is_bound_only = true;
    node.normal_B.setZero();
    node.cone_cosine = -1.0;
}

void LevelDraft::look(LevelSurface& surface, std::int32_t piece_now) {
    constexpr double kClosed = 0.05;  // a mean normal that is mere chance
    Vector3 sum = Vector3::Zero();
    double area = 0.0;
    const auto triangles = surface.triangles_of(piece_now);
    for (const std::int32_t triangle : triangles) {
        const PieceTriangle at = surface.places(triangle);
        const Vector3 doubled = (at[1] - at[0]).cross(at[2] - at[0]);
        sum += doubled;
        area += doubled.norm();
    }
    node.normal_B = area > 0.0 ? Vector3(sum / area) : Vector3(Vector3::Zero());
    node.cone_cosine = -1.0;
    const double length = node.normal_B.norm();
    if (length < kClosed) {
        node.normal_B.setZero();
        return;
    }
    node.cone_cosine = 1.0;
    for (const std::int32_t triangle : triangles) {
        for (const std::int32_t corner : surface.corners(triangle)) {
            for (const std::int32_t beside : surface.triangles_at(corner)) {
                const PiecePlane plane = PiecePlane::of(surface.places(beside));
                node.cone_cosine =
                    std::min(node.cone_cosine, plane.normal.dot(node.normal_B) / length);
            }
        }
    }
}

void LevelDraft::find_sphere() {
    Vector3 lower = points.front();
    Vector3 upper = lower;
    for (const Vector3& point : points) {
        lower = lower.cwiseMin(point);
        upper = upper.cwiseMax(point);
    }
    node.centre_B = 0.5 * (lower + upper);
    node.radius_m = 0.0;
    for (const Vector3& point : points) {
        node.radius_m = std::max(node.radius_m, (point - node.centre_B).norm());
    }
}

double LevelDraft::measure_outside_m(const std::vector<Vector3>& corners) const {
    const HullView hull{.points = points, .first_link = first_link, .links = links};
    double most_m = 0.0;
    for (const Vector3& corner : corners) {
        most_m = std::max(most_m, find_nearest_in_hull(hull, corner).gap_m);
    }
    return most_m;
}

}  // namespace fulcrum
