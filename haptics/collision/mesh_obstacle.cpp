#include "haptics/collision/mesh_obstacle.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

// How far around a way triangles are remembered: of the reach asked for, and of the ball's radius.
constexpr double kReach = 1.0;
constexpr double kRadius = 0.25;
// A long way through a mesh is asked for in pieces of this many reaches.
constexpr double kPiece = 4.0;
constexpr double kMostPieces = 64.0;

Box box_around(const Vector3& from, const Vector3& to, double margin_m) noexcept {
    const Vector3 margin = Vector3::Constant(margin_m);
    return {from.cwiseMin(to) - margin, from.cwiseMax(to) + margin};
}

// Are both ends of the way above the triangle, as seen along the direction?
bool separates(const Vector3& direction, const TriangleForGap& triangle,
               const CastQuestion& question, double distance_m) noexcept {
    const double lowest = std::min(direction.dot(question.from_B), direction.dot(question.to_B));
    return lowest - triangle.highest_along(direction) >= distance_m;
}

// Does a plane, the triangle's own or one of those given, show at once that it is not met?
bool is_apart(const TriangleForGap& triangle, const CastQuestion& question,
              double distance_m) noexcept {
    const double from_m = triangle.normal.dot(question.from_B);
    const double to_m = triangle.normal.dot(question.to_B);
    if (std::min(from_m, to_m) - triangle.highest_m >= distance_m ||
        triangle.lowest_m - std::max(from_m, to_m) >= distance_m) {
        return true;
    }
    return std::any_of(question.normals_B.begin(), question.normals_B.end(),
                       [&](const Vector3& normal_B) noexcept {
                           return separates(normal_B, triangle, question, distance_m);
                       });
}

// Along the edge, if it is one.
Vector3 find_straight(const TriangleForGap& triangle, TrianglePart part) noexcept {
    switch (part) {
        case TrianglePart::ab:
            return triangle.ab.normalized();
        case TrianglePart::ac:
            return triangle.ac.normalized();
        case TrianglePart::bc:
            return (triangle.ac - triangle.ab).normalized();
        default:
            return Vector3::Zero();
    }
}

}  // namespace

MeshObstacle::MeshObstacle(std::shared_ptr<const CollisionMesh> mesh, double radius_m)
    : mesh_(std::move(mesh)), ball_radius_m_(radius_m) {}

CastHit MeshObstacle::cast(const CastQuestion& question) noexcept {
    const double around_m = ball_radius_m_ + question.level_m;
    const Box swept = box_around(question.from_B, question.to_B, around_m);
    if (!mesh_->tree().root_box().overlaps(swept)) {
        return {};
    }
    if (!near_.covers(swept)) {
        const double length_m = (question.to_B - question.from_B).norm();
        const double margin_m = std::max(kReach * question.reach_m, kRadius * ball_radius_m_);
        if (length_m > kPiece * (margin_m + around_m) ||
            !near_.collect(*mesh_,
                           box_around(question.from_B, question.to_B, around_m + margin_m))) {
            return cast_through_tree(question);
        }
    }
    return cast_remembered(question);
}

CastHit MeshObstacle::cast_remembered(const CastQuestion& question) const noexcept {
    CastHit nearest;
    const double distance_m = ball_radius_m_ + question.level_m;
    near_.for_each_near_way(
        question.from_B, question.to_B, distance_m, [&](std::int32_t index) noexcept {
            const TriangleForGap triangle = prepare_for_gap(*mesh_, index);
            if (!is_apart(triangle, question, distance_m)) {
                meet(triangle, find_triangle_gap(triangle, question.from_B), question, nearest);
            }
        });
    return nearest;
}

CastHit MeshObstacle::cast_through_tree(const CastQuestion& question) const noexcept {
    const Vector3 way = question.to_B - question.from_B;
    const double wanted =
        way.norm() / (kPiece * (ball_radius_m_ + question.level_m + question.reach_m));
    const int n_pieces = static_cast<int>(std::clamp(std::ceil(wanted), 1.0, kMostPieces));
    CastHit nearest;
    for (int i = 0; i < n_pieces && !nearest.found(); ++i) {
        CastQuestion piece = question;
        piece.from_B = question.from_B + static_cast<double>(i) / n_pieces * way;
        piece.to_B = i + 1 == n_pieces
                         ? question.to_B
                         : Vector3(question.from_B + static_cast<double>(i + 1) / n_pieces * way);
        cast_piece(piece, nearest);
        if (nearest.found()) {
            nearest.t = (static_cast<double>(i) + nearest.t) / n_pieces;
        }
    }
    return nearest;
}

void MeshObstacle::cast_piece(const CastQuestion& question, CastHit& nearest) const noexcept {
    const double around_m = ball_radius_m_ + question.level_m;
    mesh_->tree().for_each_in_box(
        box_around(question.from_B, question.to_B, around_m), [&](std::int32_t index) noexcept {
            const TriangleForGap t = prepare_for_gap(*mesh_, index);
            meet(t, find_triangle_gap(t, question.from_B), question, nearest);
        });
}

void MeshObstacle::meet(const TriangleForGap& triangle, const TriangleGap& gap,
                        const CastQuestion& question, CastHit& nearest) const noexcept {
    const double distance_m = ball_radius_m_ + question.level_m;
    const double rest_m = gap.distance_m - distance_m;
    const double end = std::min(nearest.t, 1.0);
    const Vector3 way = question.to_B - question.from_B;
    if (gap.normal_B.dot(way) * end >= -std::max(rest_m, 0.0)) {
        return;
    }
    const double t = cast_convex(question, [&](const Vector3& at_B) noexcept {
        const TriangleGap there = find_triangle_gap(triangle, at_B);
        return Gap{.normal_B = there.normal_B, .gap_m = there.distance_m - ball_radius_m_};
    });
    if (t < nearest.t || (t == nearest.t && t <= 1.0 && triangle.index < nearest.feature)) {
        nearest = {t, triangle.index};
    }
}

Gap MeshObstacle::find_gap(std::int32_t feature, const Vector3& at_B) const noexcept {
    const TriangleForGap triangle = prepare_for_gap(*mesh_, feature);
    const TriangleGap seen = find_triangle_gap(triangle, at_B);
    Gap gap{.normal_B = seen.normal_B, .gap_m = seen.distance_m - ball_radius_m_};
    if (seen.part != TrianglePart::face && seen.distance_m > 0.0) {
        gap.curvature_per_m = 1.0 / seen.distance_m;
        gap.straight_B = find_straight(triangle, seen.part);
    }
    return gap;
}

// The nearest point stays where it is as long as no corner of the triangles round it comes above the plane across the normal there:
// (n d + way) . (corner - nearest) <= 0 with the distance d.
double MeshObstacle::find_bend(std::int32_t feature, const Vector3& at_B,
                               const Vector3& direction_B) const noexcept {
    constexpr double kFarthestTurn = 0.3;  // radians, where nothing ends it
    constexpr double kBeside = 1.0e-9;     // of an edge's length: a corner of the same edge
    constexpr double kSame = 1.0e-9;       // of the distance: the same place
    const TriangleForGap triangle = prepare_for_gap(*mesh_, feature);
    const TriangleGap seen = find_triangle_gap(triangle, at_B);
    const Vector3 from_nearest = seen.distance_m * seen.normal_B;
    const Vector3 nearest_B = at_B - from_nearest;
    const double same_m = kSame * seen.distance_m;
    double least_m = kFarthestTurn * seen.distance_m;
    mesh_->tree().for_each_in_box(
        box_around(nearest_B, nearest_B, same_m), [&](std::int32_t index) noexcept {
            const TriangleForGap other = prepare_for_gap(*mesh_, index);
            if (find_triangle_gap(other, nearest_B).distance_m > same_m) {
                return;
            }
            for (const Vector3& beyond_a : {Vector3(Vector3::Zero()), other.ab, other.ac}) {
                const Vector3 corner = other.a + beyond_a - nearest_B;
                const double rise = direction_B.dot(corner);
                if (rise > kBeside * corner.norm()) {
                    least_m = std::min(least_m, std::max(-from_nearest.dot(corner), 0.0) / rise);
                }
            }
        });
    return least_m;
}

std::int32_t MeshObstacle::find_nearest(const Vector3& at_B, double level_m) const noexcept {
    std::int32_t nearest = -1;
    double least_m = ball_radius_m_ + level_m;
    mesh_->tree().for_each_in_box(
        box_around(at_B, at_B, least_m), [&](std::int32_t triangle) noexcept {
            const double distance_m =
                find_triangle_gap(prepare_for_gap(*mesh_, triangle), at_B).distance_m;
            if (distance_m < least_m) {
                least_m = distance_m;
                nearest = triangle;
            }
        });
    return nearest;
}

}  // namespace fulcrum
