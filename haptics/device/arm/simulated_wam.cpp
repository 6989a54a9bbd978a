#include "haptics/device/arm/simulated_wam.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

// A hand is not farther away, nor faster: what lies beyond would overflow, and its spring pulls no harder anyway.
constexpr double kFarthest_m = 10.0;
constexpr double kFastest_m_per_s = 100.0;

Vector3 clamp(const Vector3& v, double most) noexcept {
    return v.cwiseMax(-most).cwiseMin(most);
}

}  // namespace

bool SimulatedWam::read(double now_s, DeviceReading& reading) noexcept {
    take_target();
    // A time that is no number moves nothing and is not kept.
    if (std::isfinite(now_s) && !(started_ && now_s <= now_s_)) {
        if (started_) {
            advance_to(now_s);
        }
        now_s_ = now_s;
        started_ = true;
    }
    reading.pose_D = to_D(counted_);
    reading.stamp_s = now_s;
    reading.buttons = buttons_;
    return true;
}

bool SimulatedWam::write(double now_s, const Wrench& wrench_D) noexcept {
    const bool usable = is_finite(wrench_D);
    // More than any motor gives in any posture is scaled down by the arm; here it must not overflow.
    constexpr double kMost = 1.0e6;
    const double largest = usable ? std::max(wrench_D.force.cwiseAbs().maxCoeff(),
                                             wrench_D.torque.cwiseAbs().maxCoeff())
                                  : 0.0;
    const double scale = largest > kMost ? kMost / largest : 1.0;
    const Wrench wrench =
        usable ? Wrench{wrench_D.force * scale, wrench_D.torque * scale} : Wrench{};
    const double written_s = std::isfinite(now_s) ? std::max(now_s, now_s_) : now_s_;
    const double from_s = written_s + settings_.delay_s;
    return pending_.put(from_s, wrench, now_s_, wrench_D_) && usable;
}

void SimulatedWam::reset() noexcept {
    motion_.hold(settings_.grip);
    started_ = false;
    now_s_ = 0.0;
    pending_.clear();
    wrench_D_ = Wrench{};
    buttons_ = 0;
    const int n = settings_.model.n;
    state_.angle_rad = settings_.workspace.home_rad;
    state_.speed_rad_per_s = JointVector::Zero(n);
    state_.holds.fill(JointHold::stuck);
    command_ = {JointVector::Zero(n), 1.0, 1.0};
    ArmPosture home;
    compute_posture(settings_.model, state_.angle_rad, home);
    aim_ = {home.handle_B, Vector3::Zero()};
    count();
}

Pose SimulatedWam::compute_pose_D() const noexcept {
    ArmPosture posture;
    compute_posture(settings_.model, twists_, state_.angle_rad, posture);
    return to_D(posture);
}

Pose SimulatedWam::to_D(const ArmPosture& posture) const noexcept {
    Pose pose_D = pose_DB_ * posture.handle_B;
    pose_D.orientation.normalize();
    return pose_D;
}

Twist SimulatedWam::compute_velocity_D() const noexcept {
    ArmPosture posture;
    compute_posture(settings_.model, state_.angle_rad, posture);
    const Vector6 motion_B = compute_motion_B(posture, state_.speed_rad_per_s);
    return {pose_DB_.orientation * motion_B.head<3>(), pose_DB_.orientation * motion_B.tail<3>()};
}

// The joints' angles by whole counts of the motors, and the posture at these: what is told, and what the arm's own computer goes by.
void SimulatedWam::count() noexcept {
    constexpr double kTurn_rad = 2.0 * std::numbers::pi;
    const ArmModel& model = settings_.model;
    JointVector motors = multiply(model.transmission, state_.angle_rad);
    for (int k = 0; k < model.n; ++k) {
        const double counts = model.motors[static_cast<std::size_t>(k)].counts_per_turn;
        if (counts > 0.0) {
            motors(k) = std::round(motors(k) * counts / kTurn_rad) * kTurn_rad / counts;
        }
    }
    counted_rad_ = multiply(joint_per_motor_, motors);
    compute_posture(model, twists_, counted_rad_, counted_);
}

// A target that cannot be used leaves the one before it.
void SimulatedWam::take_target() noexcept {
    if (!target_.take() || !is_usable(target_.value())) {
        return;
    }
    const HandTarget& wanted = target_.value();
    const Pose pose_D{clamp(wanted.pose_D.position, kFarthest_m),
                      wanted.pose_D.orientation.normalized()};
    aim_.pose_B = pose_DB_.inverse() * pose_D;
    aim_.velocity_B = pose_DB_.orientation.conjugate() * clamp(wanted.velocity_D, kFastest_m_per_s);
    buttons_ = wanted.buttons;
}

void SimulatedWam::advance_to(double now_s) noexcept {
    pending_.run(std::max(now_s_, now_s - kLongestPause_s), now_s, wrench_D_,
                 [this](double dt_s) { advance(dt_s); });
}

void SimulatedWam::advance(double dt_s) noexcept {
    // A step that is a rounding too long is one.
    constexpr double kRounding = 1.0e-9;
    const int n =
        std::max(1, static_cast<int>(std::ceil(dt_s / settings_.longest_step_s - kRounding)));
    const Quaternion to_B = pose_DB_.orientation.conjugate();
    const Wrench wrench_B{to_B * wrench_D_.force, to_B * wrench_D_.torque};
    for (int i = 0; i < n; ++i) {
        command_ = control_.step(counted_, counted_rad_, state_.speed_rad_per_s, wrench_B);
        motion_.step(command_.torque_Nm, aim_, dt_s / n, state_);
        count();
    }
}

}  // namespace fulcrum
