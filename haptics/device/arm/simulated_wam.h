// A haptic arm of seven joints that a hand holds, without hardware: Barrett's WAM, its motors, its computer, the hand.
//
//   arm_motion.h     the arm, dry and viscous friction, stops, and the hand's spring, damper and mass in six degrees
//   arm_control.h    weight held, the wrench written delay_s ago as joint torque, the elbow kept up, motors' limits
//   read             the pose of the handle from the encoders' counts, frame D
// Frame D: +Y up, +Z towards the pupil, +X to the pupil's right when the arm stands opposite; its origin is the handle in the
// home posture, where the handle is level (identity). The base's +Z is D +Y, its +X, ahead, is D +Z.
// Between two reads target and wrench are constant; the arm moves on in equal steps of at most longest_step_s, in each of
// which its computer runs once. After more than kLongestPause_s without a read only that much has passed for it.
// Pulled out straight and led back, the wrist may take its other bend, as the real one does; `reset` brings it home.
// Not in it: bending links and cables, the motors' electrical side, the network (whoever serves it adds that).
//
// Thread: `read`, `write`, `take_hold` and `reset` on the haptic thread. Cost: about 3 us a step of 0.5 ms.
// Source: its parts name theirs.
#pragma once

#include "haptics/device/arm/arm_control.h"
#include "haptics/device/arm/arm_motion.h"
#include "haptics/device/arm/arm_reach.h"
#include "haptics/device/arm/barrett_wam.h"
#include "haptics/device/device.h"
#include "haptics/device/simulated/delay_line.h"
#include "haptics/device/simulated/hand_target.h"
#include "haptics/handover/latest_value.h"

#include <array>
#include <cstddef>
#include <memory>

namespace fulcrum {

/// The arm and who holds it; SI.
struct SimulatedWamSettings {
    ArmModel model = make_barrett_wam();
    ArmWorkspace workspace{make_wam_home()};
    double posture_per_s = 3.0;      ///< how fast the elbow comes home, 0 (not at all) to 20
    double delay_s = 0.0;            ///< from `write` until the wrench acts, 0 to 0.02
    double longest_step_s = 0.0005;  ///< of its dynamics and its computer, 0.00005 to 0.002
    HandGrip grip{};
};

/// Refuses settings outside the ranges named above, NaN included; whether the workspace can be reached, `create` finds.
[[nodiscard]] Expected<void> validate(const SimulatedWamSettings& settings);

class SimulatedWam final : public Device {
  public:
    /// Wrenches on their way at once: delay_s at 5 kHz, and as many again.
    static constexpr std::size_t kMostPending = DelayLine<Wrench>::kMost;
    static constexpr double kLongestPause_s = 0.1;

    /// Settings that `validate` and compute_reach accept. `target` must outlive the arm; this is its only reader.
    [[nodiscard]] static Expected<std::unique_ptr<SimulatedWam>> create(
        const SimulatedWamSettings& settings, LatestValue<HandTarget>& target);
    ~SimulatedWam() override;

    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    /// Moves the arm on to `now_s` and reports where its encoders see it. Always true.
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    /// The wrench from `now_s` + delay_s on; a time that is not finite or before the last read is that of the last read.
    /// False for a wrench that is not finite, which leaves none, and when kMostPending are on their way.
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;

    /// Another hand takes the handle where it is, or, with kNoGrip, lets it go. Values as in the settings.
    void take_hold(const HandGrip& grip) noexcept { motion_.hold(grip); }
    /// Back to the home posture, at rest, with no wrench now or on its way, held as the settings say.
    void reset() noexcept;

    /// The true pose of the handle, frame D: what the encoders round.
    [[nodiscard]] Pose compute_pose_D() const noexcept;
    /// Its true velocity, frame D.
    [[nodiscard]] Twist compute_velocity_D() const noexcept;
    /// Angles, velocities and what each joint does.
    [[nodiscard]] const ArmState& state() const noexcept { return state_; }
    /// What the motors were last asked for, and how much of the wrench that was.
    [[nodiscard]] const ArmCommand& command() const noexcept { return command_; }
    [[nodiscard]] const ArmModel& model() const noexcept { return settings_.model; }

  private:
    SimulatedWam(const SimulatedWamSettings& settings, const ArmReach& reach,
                 LatestValue<HandTarget>& target);
    void count() noexcept;
    [[nodiscard]] Pose to_D(const ArmPosture& posture) const noexcept;
    void take_target() noexcept;
    void advance_to(double now_s) noexcept;
    void advance(double dt_s) noexcept;

    SimulatedWamSettings settings_;
    DeviceTraits traits_;
    LatestValue<HandTarget>& target_;
    Pose pose_DB_{};
    ArmTwists twists_;
    JointMatrix joint_per_motor_;  // T^-1
    ArmControl control_;
    ArmMotion motion_;
    // Time.
    bool started_ = false;
    double now_s_ = 0.0;
    // What acts, and what is on its way.
    GripTarget aim_{};
    std::uint32_t buttons_ = 0;
    Wrench wrench_D_{};
    DelayLine<Wrench> pending_;
    // Where it is.
    ArmCommand command_{};
    ArmState state_{};
    // How its encoders see that.
    JointVector counted_rad_;
    ArmPosture counted_{};
};

}  // namespace fulcrum
