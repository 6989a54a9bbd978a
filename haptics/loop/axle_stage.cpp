// The step path of axle_stage.h.
#include "haptics/loop/axle_stage.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kLongestAxleStep_s = 0.01;  // after a pause it goes on instead of leaping
constexpr double kFastest_rad_per_s = 1.0e3;

// The planned axle elsewhere. No place of the body is farther from the new pivot than from the planned one and that from it.
AxleSettings put_on_pivot(const AxlePlan& plan, const Vector3& pivot_B) noexcept {
    AxleSettings moved = move_pivot(plan.axle, pivot_B);
    const double reach_m = plan.reach_m + compute_axle_distance_m(plan.axle, pivot_B);
    moved.inertia_kg_m2 = std::max(moved.inertia_kg_m2, kLeastRimMass_kg * reach_m * reach_m);
    return moved;
}

}  // namespace

// True when the body has been put elsewhere at once: at another angle, or on another pivot.
bool AxleStage::take_order(const AxleOrder& order, Axle& axle) noexcept {
    bool is_put = false;
    // Each by itself: a pivot that cannot be leaves the load that can.
    if (order.is_set && compute_length(order.pivot_B) <= kFarthestOnAxle_m) {
        const double load_N = axle.settings.load_N;
        is_put = axle.settings.pivot_B != order.pivot_B;
        axle.settings = put_on_pivot(axle.plan, order.pivot_B);
        axle.settings.load_N = load_N;
    }
    if (order.is_set && std::isfinite(order.load_N)) {
        axle.settings.load_N = std::clamp(order.load_N, 0.0, kMostAxleLoad_N);
    }
    if (order.n_spins != std::exchange(axle.n_spins, order.n_spins) &&
        std::abs(order.spin_rad_per_s) <= kFastest_rad_per_s) {
        axle.state.spin_rad_per_s = order.spin_rad_per_s;
    }
    if (order.n_angles != std::exchange(axle.n_angles, order.n_angles) &&
        std::abs(order.angle_rad) <= kAnyAngle_rad) {
        axle.state.angle_rad =
            std::clamp(order.angle_rad, axle.settings.lowest_rad, axle.settings.highest_rad);
        is_put = true;
    }
    return is_put;
}

std::span<const Pose> AxleStage::turn(std::span<const Pose> poses_W) noexcept {
    const bool is_told = channels_ != nullptr && channels_->orders.take();
    put_ = 0;
    std::copy(poses_W.begin(), poses_W.end(), poses_W_.begin());
    for (std::size_t i = 0; i < axles_.size(); ++i) {
        Axle& axle = axles_[i];
        if (is_told && take_order(channels_->orders.value().axles[i], axle)) {
            put_ |= 1U << axle.solid;
        }
        axle.rest_W = poses_W[axle.solid];
        poses_W_[axle.solid] =
            compute_turned_pose(axle.settings, axle.state.angle_rad, axle.rest_W);
    }
    return {poses_W_.data(), poses_W.size()};
}

void AxleStage::push(const ProxyContact& contact, const HandPush& hand, double dt_s) noexcept {
    for (std::size_t i = 0; i < axles_.size(); ++i) {
        const auto solid = static_cast<std::int32_t>(axles_[i].solid);
        move_on(i, compute_solid_push(contact, solid, hand.force_W, cursor_m_),
                {.force_N = hand.most_N}, dt_s);
    }
    tell();
}

void AxleStage::push_by_tool(std::span<const SolidPush> pushes, const MostFelt& most,
                             double dt_s) noexcept {
    for (std::size_t i = 0; i < axles_.size(); ++i) {
        move_on(i, pushes[axles_[i].solid], most, dt_s);
    }
    tell();
}

void AxleStage::move_on(std::size_t i, SolidPush push, const MostFelt& most, double dt_s) noexcept {
    Axle& axle = axles_[i];
    AxleReport& report = frame_.axles[i];
    (void)limit_push(most, push);
    report.pivot_W = axle.rest_W.position + axle.settings.pivot_B;
    report.touched = push.touches;
    report.at_W = push.at_W;
    report.force_W = push.force_W;
    report.torque_Nm =
        compute_axle_torque_Nm(axle.settings, report.pivot_W, push.at_W, push.force_W) +
        axle.settings.axis_W.dot(push.couple_W);
    report.load_torque_Nm = compute_load_torque_Nm(axle.settings, axle.state.angle_rad);
    step_axle(axle.settings, report.torque_Nm, std::min(dt_s, kLongestAxleStep_s), axle.state);
    report.angle_rad = axle.state.angle_rad;
    report.spin_rad_per_s = axle.state.spin_rad_per_s;
    report.inertia_kg_m2 = axle.settings.inertia_kg_m2;
    report.load_N = axle.settings.load_N;
    report.pose_W = compute_turned_pose(axle.settings, axle.state.angle_rad, axle.rest_W);
    report.load_W = report.pivot_W + compute_load_arm_W(axle.settings, axle.state.angle_rad);
}

void AxleStage::tell() noexcept {
    if (channels_ != nullptr) {
        channels_->frame.publish(frame_);
    }
}

}  // namespace fulcrum
