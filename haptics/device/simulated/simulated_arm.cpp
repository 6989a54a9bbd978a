#include "haptics/device/simulated/simulated_arm.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

bool SimulatedArm::read(double now_s, DeviceReading& reading) noexcept {
    has_target_ = target_.take() || has_target_;
    // Before anybody wants anything usable the hand stays where it started, and still gives way.
    aim_ = HandTarget{};
    aim_.pose_D.position = settings_.start_D;
    if (has_target_ && is_usable(target_.value())) {
        aim_ = target_.value();
    }
    // A time that is no number moves nothing and is not kept.
    if (std::isfinite(now_s) && !(started_ && now_s <= now_s_)) {
        if (started_) {
            advance_to(now_s);
        }
        now_s_ = now_s;
        started_ = true;
    }
    // The encoder counts whole steps.
    reading.pose_D = {position_D(), aim_.pose_D.orientation.normalized()};
    if (const double step_m = settings_.position_resolution_m; step_m > 0.0) {
        reading.pose_D.position = (reading.pose_D.position / step_m).cwiseRound() * step_m;
    }
    reading.stamp_s = now_s;
    reading.buttons = aim_.buttons;
    return true;
}

bool SimulatedArm::write(double now_s, const Wrench& wrench_D) noexcept {
    const bool usable = is_finite(wrench_D);
    Vector3 force_D = usable ? wrench_D.force : Vector3::Zero();
    if (const double length_N = compute_length(force_D); length_N > settings_.max_force_N) {
        force_D *= settings_.max_force_N / length_N;
    }
    const double written_s = std::isfinite(now_s) ? std::max(now_s, now_s_) : now_s_;
    const double from_s = written_s + settings_.delay_s;
    return pending_.put(from_s, force_D, now_s_, force_D_) && usable;
}

void SimulatedArm::take_hold(const HumanImpedance& human) noexcept {
    human_ = human;
    motion_.fill(AxisMotion({settings_.mass_kg + human.mass_kg,
                             settings_.damping_Ns_per_m + human.damping_Ns_per_m,
                             human.stiffness_N_per_m, settings_.dry_friction_N}));
}

void SimulatedArm::reset() noexcept {
    take_hold(settings_.human);
    started_ = false;
    pending_.clear();
    force_D_.setZero();
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        axes_[i] = {settings_.start_D[static_cast<Index>(i)], 0.0};
    }
}

Vector3 SimulatedArm::position_D() const noexcept {
    return {axes_[0].position_m, axes_[1].position_m, axes_[2].position_m};
}

Vector3 SimulatedArm::velocity_D() const noexcept {
    return {axes_[0].velocity_m_per_s, axes_[1].velocity_m_per_s, axes_[2].velocity_m_per_s};
}

void SimulatedArm::advance_to(double now_s) noexcept {
    pending_.run(now_s_, now_s, force_D_, [this](double dt_s) { advance(dt_s); });
}

void SimulatedArm::advance(double dt_s) noexcept {
    // All that does not depend on where the arm is.
    const Vector3 push_D = human_.stiffness_N_per_m * aim_.pose_D.position +
                           human_.damping_Ns_per_m * aim_.velocity_D + force_D_;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        motion_[i].step(axes_[i], push_D[static_cast<Index>(i)], dt_s);
    }
}

}  // namespace fulcrum
