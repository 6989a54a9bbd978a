// The step path of axle_stage.h.
#include "haptics/loop/axle_stage.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kLongestStep_s = 0.01;  // after a pause it goes on instead of leaping
constexpr double kFastest_rad_per_s = 1.0e3;

// What of the coupling's stretch is held by one solid.
Vector3 compute_hold(const ProxyContact& contact, std::int32_t solid) noexcept {
    Vector3 hold_W = Vector3::Zero();
    for (const SolidTouch& touch : contact.active()) {
        if (touch.solid == solid) {
            hold_W += touch.push_m * touch.normal_W + touch.drag_W;
        }
    }
    return hold_W;
}

// The share of the hand's force that one solid takes, all of it where it alone is touched.
Vector3 compute_share(const ProxyContact& contact, std::int32_t solid,
                      const Vector3& force_W) noexcept {
    bool alone = contact.solid == solid;
    for (const SolidTouch& touch : contact.active()) {
        alone = alone && touch.solid == solid;
    }
    if (alone) {
        return force_W;
    }
    Vector3 all_W = Vector3::Zero();
    for (const SolidTouch& touch : contact.active()) {
        all_W += touch.push_m * touch.normal_W + touch.drag_W;
    }
    const double stretch_m = compute_length(all_W);
    return stretch_m > 0.0
               ? Vector3(compute_length(force_W) / stretch_m * compute_hold(contact, solid))
               : Vector3(Vector3::Zero());
}

// The coupling's force without what its damper drags along a surface without friction.
Vector3 compute_held_force(const ProxyContact& contact, const Vector3& force_W,
                           const Vector3& spring_W) noexcept {
    for (const SolidTouch& touch : contact.active()) {
        if (touch.drag_W.squaredNorm() > 0.0) {
            return force_W;
        }
    }
    return spring_W + contact.normal_W.dot(force_W - spring_W) * contact.normal_W;
}

}  // namespace

// True when the body has been put elsewhere at once: at another angle, or on another pivot.
bool AxleStage::take_order(const AxleOrder& order, Axle& axle) noexcept {
    bool is_put = false;
    if (order.is_set && order.pivot_B.allFinite() && std::isfinite(order.load_N)) {
        is_put = axle.settings.pivot_B != order.pivot_B;
        axle.settings.pivot_B = order.pivot_B;
        axle.settings.load_N = std::max(order.load_N, 0.0);
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

std::span<const Pose> AxleStage::turn(std::span<const Pose> poses_W, Proxy& proxy) noexcept {
    const bool is_told = channels_ != nullptr && channels_->orders.take();
    std::copy(poses_W.begin(), poses_W.end(), poses_W_.begin());
    for (std::size_t i = 0; i < axles_.size(); ++i) {
        Axle& axle = axles_[i];
        const bool is_put = is_told && take_order(channels_->orders.value().axles[i], axle);
        axle.rest_W = poses_W[axle.solid];
        Pose& turned_W = poses_W_[axle.solid];
        turned_W = compute_turned_pose(axle.settings, axle.state.angle_rad, axle.rest_W);
        if (is_put) {
            proxy.put_solid(axle.solid, turned_W);
        }
    }
    return {poses_W_.data(), poses_W.size()};
}

void AxleStage::push(const ProxyContact& contact, const Vector3& force_W, const Vector3& spring_W,
                     double dt_s) noexcept {
    const Vector3 held_W = compute_held_force(contact, force_W, spring_W);
    const double force_N = compute_length(held_W);
    const double share = force_N > most_force_N_ ? most_force_N_ / force_N : 1.0;
    const Vector3 at_W = contact.position_W - cursor_m_ * contact.normal_W;
    for (std::size_t i = 0; i < axles_.size(); ++i) {
        Axle& axle = axles_[i];
        AxleReport& report = frame_.axles[i];
        const auto solid = static_cast<std::int32_t>(axle.solid);
        report.pivot_W = axle.rest_W.position + axle.settings.pivot_B;
        report.touched = contact.solid == solid;
        for (const SolidTouch& touch : contact.active()) {
            report.touched = report.touched || touch.solid == solid;
        }
        report.at_W = at_W;
        report.force_W = report.touched ? Vector3(-share * compute_share(contact, solid, held_W))
                                        : Vector3(Vector3::Zero());
        report.torque_Nm =
            compute_axle_torque_Nm(axle.settings, report.pivot_W, at_W, report.force_W);
        report.load_torque_Nm = compute_load_torque_Nm(axle.settings, axle.state.angle_rad);
        step_axle(axle.settings, report.torque_Nm, std::min(dt_s, kLongestStep_s), axle.state);
        report.angle_rad = axle.state.angle_rad;
        report.spin_rad_per_s = axle.state.spin_rad_per_s;
        report.load_N = axle.settings.load_N;
        report.pose_W = compute_turned_pose(axle.settings, axle.state.angle_rad, axle.rest_W);
        report.load_W = report.pose_W * axle.settings.load_B;
    }
    if (channels_ != nullptr) {
        channels_->frame.publish(frame_);
    }
}

}  // namespace fulcrum
