// A person's hand on an arm that does not exist: it follows a target and gives way to the force that
// it is shown.
//
//   m x'' = k (x_target - x) - b (x' - v_target) + f     per axis, f the force written last, frame D
//   J e'' = -k_r e - b_r e' + tau                        e = log(q q_target^-1), the turn from target
// Between two reads target and force are constant, so each axis is a damped oscillator about
// x_target + (f + b v_target) / k and is solved exactly, whatever the time step (oscillator.h).
// The turn uses the same solution for e: exact for turns about one axis, close for small ones.
//
// Thread: `read` and `write` on the haptic thread.
// Cost: about 50 ns; exponentials again only when the time step changes.
// Source: F. Mussa-Ivaldi, N. Hogan, E. Bizzi 1985, Neural, mechanical, and geometric factors subserving
// arm posture in humans, J. Neuroscience 5(10): the arm at rest as a spring about a posture.
// T. Tsuji, P. Morasso, K. Goto, K. Ito 1995, Human hand impedance characteristics during maintained
// posture, Biological Cybernetics 72: mass, viscosity and stiffness of the hand, of the order of 1 kg,
// 10 Ns/m and some 100 N/m. The defaults lie in that order and are damped at a ratio of 0.58.
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/device.h"
#include "haptics/device/simulated/hand_target.h"
#include "haptics/device/simulated/oscillator.h"
#include "haptics/handover/latest_value.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

/// The arm and the device; fixed at load, SI.
struct SimulatedHandSettings {
    double mass_kg = 1.0;                    ///< felt at the hand, 0.05 to 20
    double stiffness_N_per_m = 300.0;        ///< 1 to 5000
    double damping_Ns_per_m = 20.0;          ///< 0 to 500
    double inertia_kg_m2 = 0.003;            ///< of hand and handle, 1e-5 to 1
    double turn_stiffness_Nm_per_rad = 3.0;  ///< 0.01 to 100
    double turn_damping_Nms_per_rad = 0.1;   ///< 0 to 10
    double position_resolution_m =
        0.0;                     ///< step of the encoder that `read` rounds to; 0 for none, to 0.01
    double max_force_N = 10.0;   ///< the device's, 0 to 100
    double max_torque_Nm = 1.0;  ///< the device's, 0 to 10
    Pose start_pose_D{};         ///< where the hand is when the first target comes
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const SimulatedHandSettings& settings);

class SimulatedHand final : public Device {
  public:
    /// Takes settings that `validate` accepted. `target` must outlive the hand; this is its only
    /// reader.
    SimulatedHand(const SimulatedHandSettings& settings, LatestValue<HandTarget>& target);
    ~SimulatedHand() override;

    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    /// Moves the arm on to `now_s` and reports where it is. Always true.
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    /// The force on the hand from now on. A wrench that is not finite is refused and leaves none.
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;

    /// Back to the start pose, at rest, with no force.
    void reset() noexcept;
    /// Velocity of the hand, frame D, metres per second.
    [[nodiscard]] const Vector3& velocity_D() const noexcept { return velocity_D_; }

  private:
    void advance(double dt_s) noexcept;

    SimulatedHandSettings settings_;
    DeviceTraits traits_;
    LatestValue<HandTarget>& target_;
    bool started_ = false;
    bool has_target_ = false;
    double now_s_ = 0.0;
    double step_dt_s_ = -1.0;  // the step that the two below were computed for
    OscillatorStep moving_{};
    OscillatorStep turning_{};
    Vector3 position_D_{Vector3::Zero()};
    Vector3 velocity_D_{Vector3::Zero()};
    Quaternion orientation_D_{Quaternion::Identity()};
    Vector3 angular_velocity_D_{Vector3::Zero()};
    Wrench wrench_D_{};
};

}  // namespace fulcrum
