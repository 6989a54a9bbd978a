// How the proxy keeps out of solids that move, and of what its cursor turns into.
#include "haptics/math/rotation.h"
#include "haptics/point/let_through.h"
#include "haptics/point/virtual_proxy.h"

#include <algorithm>
#include <limits>

namespace fulcrum {

namespace {

constexpr int kMaxProxyPushes = 8;   // features met on the way out from between solids
constexpr int kMaxSeparations = 32;  // looks for features that a ball starts in

// What it turns by after a round in which it could not: half, then a quarter.
constexpr double kLeastShare = 0.25;
// What planes that are right to rounding may push a cursor that hardly turns.
constexpr double kRounding_rad = 1.0e-8;

}  // namespace

void VirtualProxy::carry(std::span<const Pose> solid_poses_W) noexcept {
    n_casts_ = 0;
    leave_solids(std::span(solids_), proxy_W_, goal_W_);
    bool any_moved = false;
    for (std::size_t i = 0; i < std::min(solids_.size(), solid_poses_W.size()); ++i) {
        any_moved = solids_[i].take_pose(solid_poses_W[i]) || any_moved;
    }
    std::array<Vector3, kMaxTouches> anchors_W;
    anchors_W.fill(proxy_W_);
    if (any_moved) {
        for (std::size_t i = 0; i < std::min(planes_.count, kMaxTouches); ++i) {
            anchors_W[i] =
                solids_[static_cast<std::size_t>(planes_.plane[i].solid)].carried_proxy_W();
        }
        follow_touched();
    }
    look_again();
    planes_.tell_carried(proxy_W_, anchors_W, contact_);
}

// With the touched solid, or where it was; else wherever there is room.
void VirtualProxy::follow_touched() noexcept {
    const Vector3 wish_W = find_carried_wish(solids_, contact_.solid, proxy_W_);
    Blocker blocker;
    // The wish, then standing still, then going with each solid that is in the way.
    const std::optional<Vector3> carried_W = find_carried_place(
        solids_, wish_W, proxy_W_, [this](const Vector3& to_W) { return find_blocker(to_W); },
        blocker);
    if (carried_W) {
        accept(*carried_W);
    } else if (!place_between(wish_W, blocker)) {
        ++n_squeezed_;
        accept(wish_W);
        leave_surfaces();
        give_way(std::span(solids_), proxy_W_, planes_);
    }
}

// Out of the way of all: the place nearest to the wish in front of every plane met so far, until nothing is met.
bool VirtualProxy::place_between(const Vector3& wish_W, const Blocker& first) noexcept {
    Blocker blocker = first;
    Vector3 candidate_W = wish_W;
    Planes planes;
    // Each solid's planes are those where it has the proxy now, moved along: as seen from the wish.
    const auto add = [&](const ObstaclePlane& seen) noexcept {
        ObstaclePlane plane = seen;
        const Vector3 at_W = solids_[static_cast<std::size_t>(seen.solid)].carried_proxy_W();
        plane.gap_m += plane.normal_W.dot(wish_W - at_W);
        planes.plane[planes.count] = plane;
        planes.push_m[planes.count++] = 0.0;
    };
    for (std::size_t i = 0; i < std::min<std::size_t>(planes_.count, 3); ++i) {
        add(solids_[static_cast<std::size_t>(planes_.plane[i].solid)].find_plane(
            planes_.plane[i].feature));
    }
    for (int push = 0; push < kMaxProxyPushes && planes.count < kMaxPlanes; ++push) {
        add(solids_[static_cast<std::size_t>(blocker.solid)].find_plane(blocker.hit.feature));
        candidate_W = wish_W + constrain(Vector3::Zero(), planes);
        blocker = find_blocker(candidate_W);
        if (blocker.solid == kNoBody) {
            accept(candidate_W);
            return true;
        }
    }
    return false;
}

VirtualProxy::Blocker VirtualProxy::find_blocker(const Vector3& to_W) noexcept {
    std::array<Vector3, kMaxPlanes> normals_W;
    for (std::size_t i = 0; i < planes_.count; ++i) {
        normals_W[i] = planes_.plane[i].normal_W;
    }
    const std::span<const Vector3> held_W(normals_W.data(), planes_.count);
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        if (solids_[i].lets_through()) {
            continue;
        }
        const CastHit hit = solids_[i].cast(
            to_W, reach_m_, solids_[i].has_turned() ? held_W : std::span<const Vector3>{});
        if (hit.found()) {
            return {static_cast<std::int32_t>(i), hit};
        }
    }
    return {};
}

void VirtualProxy::accept(const Vector3& proxy_W) noexcept {
    proxy_W_ = proxy_W;
    for (MovingObstacle& solid : solids_) {
        solid.put_proxy(proxy_W);
    }
}

// Out of all that it is in, the deepest first: to the nearest place in front of their planes.
void VirtualProxy::leave_surfaces() noexcept {
    Planes planes;
    for (int look = 0; look < kMaxSeparations; ++look) {
        const std::size_t before = planes.count;
        for (std::size_t i = 0; i < solids_.size() && planes.count < kMaxPlanes; ++i) {
            const std::int32_t feature = solids_[i].lets_through() ? -1 : solids_[i].find_deepest();
            if (feature >= 0) {
                planes.plane[planes.count++] = solids_[i].find_plane(feature);
            }
        }
        if (planes.count == before) {
            return;
        }
        accept(proxy_W_ + constrain(Vector3::Zero(), planes));
        for (std::size_t i = 0; i < planes.count; ++i) {
            planes.plane[i] = solids_[static_cast<std::size_t>(planes.plane[i].solid)].find_plane(
                planes.plane[i].feature);
        }
    }
}

Quaternion VirtualProxy::turn(const Quaternion& hand_turn_W) noexcept {
    if (!(turning_.farthest_m > turning_.least_m)) {
        return hand_turn_W;
    }
    if (hand_turn_W.coeffs().allFinite() && is_fresh_) {
        put_turn(hand_turn_W.normalized());
        reset(goal_W_);
        is_fresh_ = false;
    } else if (hand_turn_W.coeffs().allFinite()) {
        follow_turn(hand_turn_W);
    }
    return turn_W_;
}

void VirtualProxy::follow_turn(const Quaternion& hand_turn_W) noexcept {
    const double stretch_m = (proxy_W_ - goal_W_).norm();
    const double height_m = turning_.farthest_m - turning_.least_m;
    loan_.allow(turning_.stiffness_N_per_m * height_m * (stretch_m + 0.5 * height_m),
                turning_.period_s);
    const Vector3 way = compute_log(hand_turn_W * turn_W_.conjugate());
    const double angle_rad = way.norm();
    if (!(angle_rad > 0.0)) {
        return;
    }
    n_casts_ = 0;
    const double share = turn_share_ * std::min(kMostTurn_rad / angle_rad, 1.0);
    const Quaternion next_W =
        share < 1.0 ? compute_exp(share * way) * turn_W_ : hand_turn_W.normalized();
    turn_share_ =
        try_turn(next_W, share * angle_rad) ? 1.0 : std::max(0.5 * turn_share_, kLeastShare);
}

// Out of what the turn brings it into, then as near to the goal as it may be now. False when it cannot: then all is as it was.
bool VirtualProxy::try_turn(const Quaternion& turn_W, double angle_rad) noexcept {
    const Quaternion before_W = turn_W_;
    const Vector3 place_W = proxy_W_;
    const Planes planes = planes_;
    const double before_J = held_J();
    put_turn(turn_W);
    if (make_room(kMostPush * turning_.farthest_m * (angle_rad + kRounding_rad))) {
        reach_m_ = std::max((proxy_W_ - place_W).norm(), std::numeric_limits<double>::min());
        find_near_solids(goal_W_);
        follow_goal(goal_W_, kMostTurnCasts);
        if (loan_.may_give(held_J() - before_J)) {
            publish(goal_W_);
            return true;
        }
    }
    put_turn(before_W);
    accept(place_W);
    planes_ = planes;
    look_again();
    return false;
}

bool VirtualProxy::make_room(double most_m) noexcept {
    const Blocker blocker = find_blocker(proxy_W_);
    if (blocker.solid != kNoBody) {
        const Vector3 before_W = proxy_W_;
        return place_between(before_W, blocker) && (proxy_W_ - before_W).norm() <= most_m;
    }
    accept(proxy_W_);
    return true;
}

void VirtualProxy::put_turn(const Quaternion& turn_W) noexcept {
    turn_W_ = turn_W;
    const Matrix3 turn_WC = turn_W.toRotationMatrix();
    for (MovingObstacle& solid : solids_) {
        solid.turn_cursor(turn_WC);
    }
}

double VirtualProxy::held_J() const noexcept {
    return 0.5 * turning_.stiffness_N_per_m * (proxy_W_ - goal_W_).squaredNorm();
}

}  // namespace fulcrum
