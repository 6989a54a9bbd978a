#include "haptics/levels/level_draft.h"

#include "haptics/geometry/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {

void LevelDraft::take_points(const PieceShape& shape, double slack_m) {
    if (shape.is_flat(slack_m)) {
        points = find_flat_hull(shape.corners, shape.planes.front().normal);
        return;
    }
    points = shape.corners;
    if (points.size() >= kClimbFrom) {
        take_hull(shape.corners);
    }
}

void LevelDraft::take_hull(const std::vector<Vector3>& corners) {
    points = corners;
    faces.clear();
    const Expected<TriangleMesh> hull = make_convex_hull(corners);
    if (!hull) {
        if (node.normal_B.norm() > 0.0) {
            points = find_flat_hull(corners, node.normal_B.normalized());
        }
        for (std::size_t i = 2; i < points.size(); ++i) {
            faces.push_back({points[0], points[i - 1], points[i]});
        }
        return;
    }
    points = hull->vertices_B();
    for (const TriangleCorners& triangle : hull->triangles()) {
        const auto place = [this](std::int32_t i) { return points[static_cast<std::size_t>(i)]; };
        faces.push_back({place(triangle[0]), place(triangle[1]), place(triangle[2])});
    }
    if (points.size() < kClimbFrom) {
        return;
    }
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
    area_m2 = 0.5 * area;
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

void LevelDraft::look_as(std::span<const LevelDraft* const> below) {
    node.normal_B.setZero();
    for (const LevelDraft* one : below) {
        area_m2 += one->area_m2;
        node.normal_B += one->area_m2 * one->node.normal_B;
    }
    node.normal_B /= area_m2 > 0.0 ? area_m2 : 1.0;
    node.cone_cosine = -1.0;
    const auto angle_of = [](double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); };
    double widest = 0.0;
    for (const LevelDraft* one : below) {
        const double lengths = one->node.normal_B.norm() * node.normal_B.norm();
        if (!(lengths > 0.0)) {
            return;
        }
        widest = std::max(widest, angle_of(one->node.normal_B.dot(node.normal_B) / lengths) +
                                      angle_of(one->node.cone_cosine));
    }
    node.cone_cosine = std::cos(std::min(widest, std::numbers::pi));
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

double LevelDraft::measure_bulge_m(const SurfaceDistance& surface, double apart_m,
                                   double enough_m) const {
    constexpr int kMostParts = 4;
    double most_m = 0.0;
    for (const PieceTriangle& face : faces) {
        const double longest_m = std::sqrt(
            std::max({(face[1] - face[0]).squaredNorm(), (face[2] - face[1]).squaredNorm(),
                      (face[0] - face[2]).squaredNorm()}));
        const int n = std::clamp(static_cast<int>(std::ceil(longest_m / apart_m)), 2, kMostParts);
        for (int i = 0; i <= n; ++i) {
            for (int k = 0; i + k <= n; ++k) {
                // Its corners are the mesh's own.
                if (i == n || k == n || i + k == 0) {
                    continue;
                }
                const Vector3 point = face[0] + (static_cast<double>(i) * (face[1] - face[0]) +
                                                 static_cast<double>(k) * (face[2] - face[0])) /
                                                    static_cast<double>(n);
                most_m = std::max(most_m, surface.measure_height_m(point, 0.1 * apart_m));
            }
        }
        if (most_m > enough_m) {
            break;
        }
    }
    return most_m;
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
