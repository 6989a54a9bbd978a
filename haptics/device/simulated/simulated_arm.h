// A haptic arm with all that makes a stiff wall buzz, and the hand that holds it: the closed loop without hardware.
//
//   (m + m_h) x'' = k_h (x_target - x) - b_h (x' - v_target) - b x' - f_c sgn(x') + f(t)      per axis, frame D
//   f(t)      what was written delay_s ago, held until the next takes effect, shortened to max_force_N
//   read      x, rounded to whole steps of the encoder
// m, b, f_c: the device's; m_h, b_h, k_h: the hand's (human_impedance.h). Between two events target and force are constant
// and each axis is solved exactly (oscillator.h), so the result depends neither on the time step nor on how a delay cuts
// it. The spring's equilibrium moves with the target only at a `read`. The stylus turns freely: it has the orientation of
// the target, and a torque moves nothing. Not in it: the arm's flexible structure and its amplifier, which make a real
// arm's walls softer than this one's.
//
// Thread: `read`, `write`, `take_hold` and `reset` on the haptic thread.
// Cost: about 100 ns; more when an axis stops or turns within a step.
// Source: the factors are those of J. E. Colgate, J. M. Brown 1994, Factors affecting the Z-width of a haptic display,
// Proc. IEEE Int. Conf. Robotics and Automation, and N. Diolaiti, G. Niemeyer, F. Barbagli, J. K. Salisbury 2006, Stability
// of haptic rendering: discretization, quantization, time delay, and Coulomb effects, IEEE Trans. Robotics 22(2).
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/device.h"
#include "haptics/device/simulated/delay_line.h"
#include "haptics/device/simulated/hand_target.h"
#include "haptics/device/simulated/human_impedance.h"
#include "haptics/device/simulated/oscillator.h"
#include "haptics/handover/latest_value.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstddef>

namespace fulcrum {

/// The arm and who holds it; SI. The defaults are an arm without a fault: no friction, no steps, no delay.
struct SimulatedArmSettings {
    double mass_kg = 0.045;              ///< of the device, felt at the handle, 0.001 to 100
    double dry_friction_N = 0.0;         ///< Coulomb's, of each axis, 0 to 10
    double damping_Ns_per_m = 0.0;       ///< viscous friction, 0 to 1000
    double position_resolution_m = 0.0;  ///< step of the encoder; 0 for none, to 0.01
    double delay_s = 0.0;                ///< from `write` until the force acts, 0 to 0.02
    double max_force_N = 10.0;           ///< 0 to 100; a longer force is shortened to it
    HumanImpedance human = kPosture;     ///< 0 to 100 kg, 0 to 1000 Ns/m, 0 or 1 to 1e8 N/m
    Vector3 start_D{Vector3::Zero()};    ///< where it is when the first target comes
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const SimulatedArmSettings& settings);

/// An arm like those on a classroom's desk: 45 g at the handle, 0.26 N of dry friction, steps of 55 um, 3.3 N, as the data
/// sheet of the Phantom Omni (now Touch) gives them. It gives no viscous friction: 0.5 Ns/m is assumed.
[[nodiscard]] SimulatedArmSettings make_desktop_arm();

class SimulatedArm final : public Device {
  public:
    /// Forces on their way at once: delay_s at 5 kHz, and as many again.
    static constexpr std::size_t kMostPending = DelayLine<Vector3>::kMost;

    /// Takes settings that `validate` accepted. `target` must outlive the arm; this is its only reader.
    SimulatedArm(const SimulatedArmSettings& settings, LatestValue<HandTarget>& target);
    ~SimulatedArm() override;

    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    /// Moves the arm on to `now_s` and reports where it is. Always true.
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    /// The force from `now_s` + delay_s on; a time that is not finite or before the last read is that of the last read.
    /// False for a wrench that is not finite, which leaves no force, and when kMostPending are on their way.
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;

    /// Another hand takes the arm where it is, or, with kNobody, it is let go. Values as in the settings.
    void take_hold(const HumanImpedance& human) noexcept;
    /// Back to the start, at rest, with no force now or on its way, held as the settings say.
    void reset() noexcept;

    /// Where it truly is, frame D, metres: what the encoder rounds.
    [[nodiscard]] Vector3 position_D() const noexcept;
    /// Its true velocity, frame D, metres per second.
    [[nodiscard]] Vector3 velocity_D() const noexcept;
    /// The force that acts now, frame D, newtons.
    [[nodiscard]] const Vector3& force_D() const noexcept { return force_D_; }

  private:
    void advance_to(double now_s) noexcept;
    void advance(double dt_s) noexcept;

    SimulatedArmSettings settings_;
    DeviceTraits traits_;
    LatestValue<HandTarget>& target_;
    bool has_target_ = false;
    HumanImpedance human_{};
    std::array<AxisMotion, 3> motion_{};
    // Time.
    bool started_ = false;
    double now_s_ = 0.0;
    // What acts, and what is on its way.
    HandTarget aim_{};
    Vector3 force_D_{Vector3::Zero()};
    DelayLine<Vector3> pending_;
    // Where it is.
    std::array<AxisState, 3> axes_{};
};

}  // namespace fulcrum
