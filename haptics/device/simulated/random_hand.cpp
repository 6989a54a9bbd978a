#include "haptics/device/simulated/random_hand.h"

#include "haptics/math/felt.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

constexpr double kMostTurn_rad = 0.5;
constexpr double kBegins_s = 0.1;     // what is felt again after so long begins anew
constexpr double kPatience_s = 0.15;  // without a force, before it tries something else
constexpr double kMostFollow_s = 4.0;
constexpr double kTouchSpeed_m_per_s = 0.4;
constexpr double kLift_m = 0.015;  // off what it touches
constexpr double kSearch_m = 0.02;
constexpr double kMostWay_s = 0.6;
constexpr double kNear_m = 0.02;
constexpr double kDeepens_m_per_s = 0.1;  // while it feels nothing
constexpr double kDeepest_m = 0.05;
constexpr double kDeep_m =
    0.02;  // once it feels something: deeper it would slip round what is thin
constexpr int kMostTries = 4;
constexpr double kTouchShare = 0.8;  // of the deeds that are not to follow
constexpr double kLongestStep_s = 0.01;

double ease(double share) noexcept {
    const double x = std::clamp(share, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

// Across `way`, of length 1; whichever where there is no way.
Vector3 find_across(const Vector3& way, const Vector3& chance) noexcept {
    const Vector3 across = way.squaredNorm() > 0.0 ? Vector3(way.cross(chance)) : chance;
    const double length = across.norm();
    return length > 1.0e-6 ? Vector3(across / length) : Vector3::UnitX();
}

}  // namespace

HandTarget RandomHand::step(double now_s, const HandTarget& planned,
                            const HandFeeling& felt) noexcept {
    feel(now_s, planned, felt);
    if (!started_ || has_enough(now_s)) {
        begin(now_s);
    }
    offset_D_ = deed_ == HandDeed::touch ? compute_touch(now_s, planned) : compute_offset(now_s);
    if (const double away_m = offset_D_.norm(); away_m > kFarthest_m) {
        offset_D_ *= kFarthest_m / away_m;
    }
    turn_D_ = begin_turn_D_ + ease((now_s - from_s_) / reach_s_) * (goal_turn_D_ - begin_turn_D_);
    last_s_ = now_s;
    wanted_D_ = planned.pose_D.position + offset_D_;
    HandTarget wanted = planned;
    wanted.pose_D.position = wanted_D_;
    wanted.pose_D.orientation = compute_exp(turn_D_) * planned.pose_D.orientation;
    wanted.buttons = holds() ? planned.buttons : 0;
    return wanted;
}

// A thing lies where it begins to be felt: behind that somebody may be deep in it already.
void RandomHand::feel(double now_s, const HandTarget& planned, const HandFeeling& felt) noexcept {
    felt_D_ = felt;
    sees_ = planned.sees_thing;
    thing_D_ = planned.thing_D;
    if (!(felt.force_D.norm() > kLeastFelt_N)) {
        return;
    }
    const bool begins = now_s - felt_s_ > kBegins_s;
    felt_s_ = now_s;
    tries_ = 0;
    if (begins) {
        place_D_ = felt.position_D - thing_D_;
        into_D_ = felt.force_D / -felt.force_D.norm();
        depth_m_ = std::min(depth_m_, kDeep_m);
    }
}

// Deeper in than where it was felt, and nothing is felt: as of a gate that waits until nobody presses.
bool RandomHand::misses(double now_s) const noexcept {
    const Vector3 way_D = felt_D_.position_D - thing_D_ - place_D_;
    return sees_ && !into_D_.isZero() && now_s - std::max(felt_s_, from_s_) > kPatience_s &&
           way_D.dot(into_D_) > 0.0 && way_D.norm() < kNear_m;
}

// Who follows stays where something is felt, and where things can be touched not for long where nothing is.
bool RandomHand::has_enough(double now_s) const noexcept {
    if (deed_ != HandDeed::follow || !sees_) {
        return now_s >= until_s_;
    }
    const bool feels = felt_s_ >= from_s_ && now_s - felt_s_ < kPatience_s;
    return now_s >= (feels ? from_s_ + kMostFollow_s : until_s_) || misses(now_s);
}

Vector3 RandomHand::compute_offset(double now_s) const noexcept {
    const double since_s = now_s - from_s_;
    return begin_D_ + ease(since_s / reach_s_) * (goal_D_ - begin_D_) +
           swing_m_ * std::sin(2.0 * std::numbers::pi * swing_Hz_ * since_s) * across_D_;
}

// Where the deed wants the handle: towards the thing until it is felt, there as deep as it likes and to and fro, or off it.
Vector3 RandomHand::find_touch_goal(double now_s) const noexcept {
    const Vector3 there_D = thing_D_ + place_D_;
    if (is_lifted_) {
        // The way it came; where that gave nothing upwards, out of what is about it.
        const bool goes_back = !into_D_.isZero() && tries_ % 2 == 0;
        const double far_m = (1 + tries_) * kLift_m;
        return goes_back ? Vector3(there_D - far_m * into_D_)
                         : Vector3(lifts_from_D_ + 2.0 * far_m * Vector3::UnitY());
    }
    if (reaches_) {
        return thing_D_ + search_D_;
    }
    return there_D + depth_m_ * into_D_ +
           swing_m_ * std::sin(2.0 * std::numbers::pi * swing_Hz_ * (now_s - from_s_)) * across_D_;
}

// No faster than a hand does.
Vector3 RandomHand::compute_touch(double now_s, const HandTarget& planned) noexcept {
    if (felt_s_ == now_s) {
        reaches_ = false;
    } else if (now_s - std::max(felt_s_, tried_s_) > kPatience_s) {
        try_again(now_s);
    }
    const double dt_s = std::clamp(now_s - last_s_, 0.0, kLongestStep_s);
    if (felt_s_ != now_s && !is_lifted_ && !reaches_) {
        depth_m_ = std::min(depth_m_ + kDeepens_m_per_s * dt_s, kDeepest_m);
    }
    const Vector3 way_D = find_touch_goal(now_s) - wanted_D_;
    const double step_m = kTouchSpeed_m_per_s * dt_s;
    const double far_m = way_D.norm();
    if (far_m > kNear_m && now_s - phase_s_ < kMostWay_s) {
        tried_s_ = now_s;  // on the way nothing is missed
    }
    const double share = far_m > step_m ? step_m / far_m : 1.0;
    return wanted_D_ + share * way_D - planned.pose_D.position;
}

// Who is not in what he felt goes to the thing; else off, so that a gate that waits opens, and back.
void RandomHand::try_again(double now_s) noexcept {
    phase_s_ = tried_s_ = now_s;
    if (is_lifted_) {
        is_lifted_ = false;
        reaches_ = ++tries_ > 1;
    } else if (!reaches_ && !misses(now_s)) {
        reaches_ = true;
    } else {
        is_lifted_ = !reaches_ || misses(now_s) || tries_ % 2 == 0;
        tries_ += is_lifted_ ? 0 : 1;
    }
    // Its middle may be hollow.
    search_D_ = tries_ == 0 ? Vector3(Vector3::Zero()) : Vector3(kSearch_m * draw_direction());
    if (tries_ > kMostTries) {
        until_s_ = now_s;
        into_D_.setZero();
    }
}

void RandomHand::begin(double now_s) noexcept {
    const bool lifts = misses(now_s);
    deed_ = draw_deed(now_s);
    const bool follows = deed_ == HandDeed::follow;
    ++done_[static_cast<std::size_t>(deed_)];
    started_ = true;
    from_s_ = now_s;
    until_s_ = now_s + (follows                    ? draw(0.4, sees_ ? 1.0 : 4.0)
                        : deed_ == HandDeed::touch ? draw(8.0, 20.0)
                                                   : draw(0.3, 2.0));
    begin_D_ = offset_D_;
    begin_turn_D_ = turn_D_;
    choose_way();
    is_lifted_ = lifts;
    lifts_from_D_ = wanted_D_;
    phase_s_ = tried_s_ = now_s;
}

HandDeed RandomHand::draw_deed(double now_s) noexcept {
    if (!started_ || deed_ != HandDeed::follow) {
        return HandDeed::follow;
    }
    if (sees_ && (misses(now_s) || draw(0.0, 1.0) < kTouchShare)) {
        return HandDeed::touch;
    }
    constexpr int kOthers = static_cast<int>(HandDeed::let_go);
    return static_cast<HandDeed>(1 + static_cast<int>(draw(0.0, 1.0) * kOthers));
}

void RandomHand::choose_way() noexcept {
    goal_D_.setZero();
    goal_turn_D_.setZero();
    reach_s_ = draw(0.1, 0.6);
    swing_m_ = 0.0;
    swing_Hz_ = 0.0;
    across_D_.setZero();
    switch (deed_) {
        case HandDeed::press:
            goal_D_ = draw(0.02, 0.1) * draw_direction();
            goal_turn_D_ = draw(0.0, kMostTurn_rad) * draw_direction();
            break;
        case HandDeed::slide:
            goal_D_ = draw(0.0, 0.04) * draw_direction();
            across_D_ = find_across(goal_D_, draw_direction());
            swing_m_ = draw(0.01, 0.06);
            swing_Hz_ = draw(0.05, 0.5) / (2.0 * std::numbers::pi * swing_m_);
            break;
        case HandDeed::jerk:
            goal_D_ = begin_D_;
            across_D_ = draw_direction();
            swing_m_ = draw(0.005, 0.04);
            swing_Hz_ = draw(2.0, 8.0);
            break;
        case HandDeed::touch:
            across_D_ = find_across(into_D_, draw_direction());
            swing_m_ = draw(0.0, 0.005);
            swing_Hz_ = draw(0.3, 2.0);
            depth_m_ = draw(0.005, 0.02);
            tries_ = 0;
            reaches_ = into_D_.isZero();
            break;
        case HandDeed::follow:
        case HandDeed::let_go:
            break;
    }
}

// Evenly on the sphere: its heights are as likely (Archimedes).
Vector3 RandomHand::draw_direction() noexcept {
    const double height = draw(-1.0, 1.0);
    const double angle = draw(0.0, 2.0 * std::numbers::pi);
    const double radius = std::sqrt(std::max(0.0, 1.0 - height * height));
    return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

}  // namespace fulcrum
