#include "haptics/point/moving_obstacle.h"

#include <algorithm>
#include <array>

namespace fulcrum {

namespace {

// The gap that counts as met, of the clearance: the difference is what rounding may do to a proxy that slides.
constexpr double kMet = 0.5;

}  // namespace

MovingObstacle::MovingObstacle(std::unique_ptr<Obstacle> obstacle, std::int32_t index,
                               const Pose& pose_W, bool lets_out,
                               std::shared_ptr<const CollisionMesh> stuff, const Pose& shape_B)
    : obstacle_(std::move(obstacle)),
      index_(index),
      lets_out_(lets_out),
      stuff_(std::move(stuff)),
      shape_B_(shape_B),
      is_placed_(!is_same(shape_B, Pose{})) {
    take_pose(pose_W);
    tell_turn();
    obstacle_->keep_turn();
    has_turned_ = false;
}

bool MovingObstacle::take_pose(const Pose& pose_W) noexcept {
    const Pose body_W{pose_W.position, pose_W.orientation.normalized()};
    const bool moved = ProxyFrame::take_pose(is_placed_ ? body_W * shape_B_ : pose_W);
    if (moved) {
        tell_turn();
    }
    return moved;
}

void MovingObstacle::turn_cursor(const Matrix3& turn_WC) noexcept {
    turn_WC_ = turn_WC;
    tell_turn();
}

void MovingObstacle::tell_turn() noexcept {
    has_turned_ = obstacle_->turn(turn_WC_.transpose() * turn_WB());
}

void MovingObstacle::put_proxy(const Vector3& proxy_W) noexcept {
    ProxyFrame::put_proxy(proxy_W);
    if (has_turned_) {
        obstacle_->keep_turn();
        has_turned_ = false;
    }
}

double MovingObstacle::clearance_m() const noexcept {
    const double farthest_m =
        (to_world(proxy_B()) - origin_W()).cwiseAbs().maxCoeff() + origin_W().cwiseAbs().maxCoeff();
    return obstacle_->clearance_m() + rounding_m(farthest_m);
}

CastHit MovingObstacle::cast(const Vector3& to_W, double reach_m,
                             std::span<const Vector3> normals_W) noexcept {
    const Vector3 to_B = to_body(to_W);
    if (has_turned_ ? !is_near_way(to_B) : to_B == proxy_B()) {
        return {};
    }
    std::array<Vector3, kMostNormals> normals_B;
    const std::size_t n = std::min(normals_W.size(), kMostNormals);
    for (std::size_t i = 0; i < n; ++i) {
        normals_B[i] = turn_WB().transpose() * normals_W[i];
    }
    return obstacle_->cast({.from_B = proxy_B(),
                            .to_B = to_B,
                            .level_m = kMet * clearance_m(),
                            .reach_m = reach_m,
                            .normals_B = {normals_B.data(), n}});
}

ObstaclePlane MovingObstacle::find_plane(std::int32_t feature) const noexcept {
    const Gap gap = obstacle_->find_gap(feature, proxy_B());
    return {.solid = index_,
            .feature = feature,
            .normal_W = turn_WB() * gap.normal_B,
            .gap_m = gap.gap_m,
            .clearance_m = clearance_m(),
            .curvature_per_m = gap.curvature_per_m,
            .straight_W = turn_WB() * gap.straight_B};
}

Vector3 MovingObstacle::move_off(std::int32_t feature, const Vector3& p_W) const noexcept {
    const Gap gap = obstacle_->find_gap(feature, to_body(p_W));
    return p_W + (clearance_m() - gap.gap_m) * (turn_WB() * gap.normal_B);
}

bool MovingObstacle::holds(const Vector3& p_W) const noexcept {
    const Vector3 p_B = to_body(p_W);
    return lets_out_ && is_near(p_W, 0.0) &&
           (obstacle_->find_nearest(p_B, 0.0) >= 0 || (stuff_ && is_in_stuff(*stuff_, p_B)));
}

// Can a cursor on its way to there, turned anyhow, be at the solid?
bool MovingObstacle::is_near_way(const Vector3& to_B) const noexcept {
    const Vector3 way = to_B - proxy_B();
    const Vector3 to_centre = obstacle_->centre_B() - proxy_B();
    const double square = way.squaredNorm();
    const double t = square > 0.0 ? std::clamp(to_centre.dot(way) / square, 0.0, 1.0) : 0.0;
    const double reach_m = obstacle_->radius_m() * (1.0 + 1.0e-9) + clearance_m();
    return (to_centre - t * way).squaredNorm() <= reach_m * reach_m;
}

bool MovingObstacle::is_near(const Vector3& centre_W, double radius_m) const noexcept {
    const double reach_m = (obstacle_->radius_m() + radius_m) * (1.0 + 1.0e-9) + clearance_m();
    return (to_body(centre_W) - obstacle_->centre_B()).squaredNorm() <= reach_m * reach_m;
}

}  // namespace fulcrum
