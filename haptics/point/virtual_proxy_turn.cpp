// How the cursor turns with the hand.
#include "haptics/math/rotation.h"
#include "haptics/point/virtual_proxy.h"

#include <algorithm>
#include <limits>

namespace fulcrum {

namespace {

// What it turns by after a round in which it could not: half, then a quarter.
constexpr double kLeastShare = 0.25;
// What planes that are right to rounding may push a cursor that hardly turns.
constexpr double kRounding_rad = 1.0e-8;

}  // namespace

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
