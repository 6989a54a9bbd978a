// A person's hand on an arm that does not exist: it follows a target and gives way to the force that
// it is shown.
//
//   m x'' = k (x_target - x) - b (x' - v_target) + f     per axis, f the force written last, frame D
//   J e'' = -k_r e - b_r e' + tau                        e = log(q q_target^-1), the turn from target
// Between two reads target and force are constant, so each axis is a damped oscillator about
// x_target + (f + b v_target) / k and is solved exactly, whatever the time step. With
// y = x - x_equilibrium, alpha = b / 2m, w^2 = k/m - alpha^2:
//   y(t) = e^(-alpha t) (y0 c + (v0 + alpha y0) s)
//   v(t) = e^(-alpha t) (v0 c - (alpha v0 + y0 k/m) s)
//   c = cos wt, s = sin(wt)/w   (1, t when critical; when overdamped, written out as two
//   exponentials that fall, for cosh would overflow where e^(-alpha t) has become zero)
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
#include "haptics/handover/latest_value.h"
#include "haptics/math/spatial.h"

#include <cstdint>

namespace fulcrum {

/// Where the simulated person wants the hand to be, in the device's frame. Newest value; whoever
/// plays the person writes.
struct HandTarget {
    Pose pose_D{};                        ///< metres
    Vector3 velocity_D{Vector3::Zero()};  ///< metres per second; with it the hand follows a moving
                                          ///< target without lag
    std::uint32_t buttons = 0;            ///< one bit a button
};

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

/// One degree of freedom over one step of fixed length: (y, v) <- A (y, v). See the head of this
/// file.
struct OscillatorStep {
    double yy = 1.0, yv = 0.0, vy = 0.0, vv = 1.0;
};
/// The exact step over `dt_s` >= 0 of m y'' = -k y - b y'.
[[nodiscard]] OscillatorStep compute_oscillator_step(double mass, double stiffness, double damping,
                                                     double dt_s) noexcept;

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
