#include "haptics/device/simulated/random_hand.h"

#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kMostTurn_rad = 0.5;

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

HandTarget RandomHand::step(double now_s, const HandTarget& planned) noexcept {
    if (!started_ || now_s >= until_s_) {
        begin(now_s);
    }
    const double since_s = now_s - from_s_;
    const double share = ease(since_s / reach_s_);
    offset_D_ = begin_D_ + share * (goal_D_ - begin_D_) +
                swing_m_ * std::sin(kTwoPi * swing_Hz_ * since_s) * across_D_;
    if (const double away_m = offset_D_.norm(); away_m > kFarthest_m) {
        offset_D_ *= kFarthest_m / away_m;
    }
    turn_D_ = begin_turn_D_ + share * (goal_turn_D_ - begin_turn_D_);
    HandTarget wanted = planned;
    wanted.pose_D.position += offset_D_;
    wanted.pose_D.orientation = compute_exp(turn_D_) * planned.pose_D.orientation;
    wanted.buttons = holds() ? planned.buttons : 0;
    return wanted;
}

void RandomHand::begin(double now_s) noexcept {
    const bool follows = !started_ || deed_ != HandDeed::follow;
    constexpr int kOthers = static_cast<int>(kHandDeeds) - 1;
    deed_ = follows ? HandDeed::follow
                    : static_cast<HandDeed>(1 + static_cast<int>(draw(0.0, 1.0) * kOthers));
    ++done_[static_cast<std::size_t>(deed_)];
    started_ = true;
    from_s_ = now_s;
    until_s_ = now_s + (follows ? draw(0.5, 4.0) : draw(0.3, 2.0));
    begin_D_ = offset_D_;
    begin_turn_D_ = turn_D_;
    choose_way();
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
            swing_Hz_ = draw(0.05, 0.5) / (kTwoPi * swing_m_);
            break;
        case HandDeed::jerk:
            goal_D_ = begin_D_;
            across_D_ = draw_direction();
            swing_m_ = draw(0.005, 0.04);
            swing_Hz_ = draw(2.0, 8.0);
            break;
        case HandDeed::follow:
        case HandDeed::let_go:
            break;
    }
}

// Evenly on the sphere: its heights are as likely (Archimedes).
Vector3 RandomHand::draw_direction() noexcept {
    const double height = draw(-1.0, 1.0);
    const double angle = draw(0.0, kTwoPi);
    const double radius = std::sqrt(std::max(0.0, 1.0 - height * height));
    return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

}  // namespace fulcrum
