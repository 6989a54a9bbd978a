#include "haptics/device/simulated/simulated_hand.h"

#include "haptics/math/rotation.h"

#include <cmath>

namespace fulcrum {

bool SimulatedHand::read(double now_s, DeviceReading& reading) noexcept {
    has_target_ = target_.take() || has_target_;
    // A time that is no number moves nothing and is not kept.
    if (std::isfinite(now_s) && !(started_ && now_s <= now_s_)) {
        if (started_) {
            advance(now_s - now_s_);
        }
        now_s_ = now_s;
        started_ = true;
    }
    // The encoder counts whole steps.
    reading.pose_D = {position_D_, orientation_D_};
    if (const double step_m = settings_.position_resolution_m; step_m > 0.0) {
        reading.pose_D.position = (position_D_ / step_m).cwiseRound() * step_m;
    }
    reading.stamp_s = now_s;
    reading.buttons = target_.value().buttons;
    return true;
}

bool SimulatedHand::write(double /*now_s*/, const Wrench& wrench_D) noexcept {
    const bool usable = is_finite(wrench_D);
    wrench_D_ = usable ? wrench_D : Wrench{};
    return usable;
}

void SimulatedHand::reset() noexcept {
    started_ = false;
    position_D_ = settings_.start_pose_D.position;
    orientation_D_ = settings_.start_pose_D.orientation;
    velocity_D_.setZero();
    angular_velocity_D_.setZero();
    wrench_D_ = Wrench{};
}

void SimulatedHand::advance(double dt_s) noexcept {
    // A clock's rounding is no new step.
    constexpr double kSameClock = 1.0e-9;
    if (!(std::abs(dt_s - step_dt_s_) <= kSameClock * dt_s)) {
        moving_ = compute_oscillator_step(settings_.mass_kg, settings_.stiffness_N_per_m,
                                          settings_.damping_Ns_per_m, dt_s);
        turning_ =
            compute_oscillator_step(settings_.inertia_kg_m2, settings_.turn_stiffness_Nm_per_rad,
                                    settings_.turn_damping_Nms_per_rad, dt_s);
        step_dt_s_ = dt_s;
    }
    // Before anybody wants anything the hand stays where it started, and still gives way.
    HandTarget target;
    target.pose_D = settings_.start_pose_D;
    if (has_target_ && is_usable(target_.value())) {
        target = target_.value();
    }
    // Move: an oscillator about the point where spring, damper and force balance.
    const Vector3 equilibrium_D =
        target.pose_D.position +
        (wrench_D_.force + settings_.damping_Ns_per_m * target.velocity_D) /
            settings_.stiffness_N_per_m;
    const Vector3 away_D = position_D_ - equilibrium_D;
    position_D_ = equilibrium_D + moving_.yy * away_D + moving_.yv * velocity_D_;
    velocity_D_ = moving_.vy * away_D + moving_.vv * velocity_D_;
    // Turn: the same about the target's orientation.
    const Quaternion wanted = target.pose_D.orientation.normalized();
    const Vector3 rest_D = wrench_D_.torque / settings_.turn_stiffness_Nm_per_rad;
    const Vector3 turned_D = compute_log(orientation_D_ * wanted.conjugate()) - rest_D;
    const Vector3 next_D = rest_D + turning_.yy * turned_D + turning_.yv * angular_velocity_D_;
    angular_velocity_D_ = turning_.vy * turned_D + turning_.vv * angular_velocity_D_;
    orientation_D_ = compute_exp(next_D) * wanted;
    orientation_D_.normalize();
}

}  // namespace fulcrum
