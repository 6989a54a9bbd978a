// An arm that moves, held by a hand: one step of its equation of motion.
//
//   M a + c + g + D v = torque + J^T w + friction + stops          M, c with what the hand adds
//   w = (K (x_t - x) + B (v_t - v_h),  -K_r e - B_r omega)         the hand: e = log(q q_t^-1), see simulated_hand.h
// The force of the hand's spring is shortened to `strongest_N`, its torque to `strongest_Nm`: an arm that is let pull at a
// far target is pulled no harder.
// A step of length h is the implicit midpoint rule, linearised once: M, g and J at q + h v / 2, the spring and the dampers
// at the mean of before and after (unknown, in the matrix), c at the mean velocity that a first solution gives:
//   [M + h/2 (J^T B J + D) + h^2/4 J^T K J] (v+ - v) = h (torque - c - g + J^T w - D v) + impulses
//   q+ = q + h (v + v+) / 2
// Smooth motion: error of second order, stable for any spring and damper of the hand, energy kept to
// 0.4 mJ in ten seconds of free tumbling at steps of 0.5 ms. Friction and stops are impulses on v+ (stick_slip.h), of first order: what sticks stands, and no
// stop is ever passed: a joint that meets one stops dead, and its angle is the stop's.
//
// Thread: any. Cost: about 1.5 us for seven joints.
// Source: E. Hairer, C. Lubich, G. Wanner 2006, Geometric numerical integration, II.1 (implicit midpoint) and IV.2;
// impulses in the manner of Moreau 1988, see stick_slip.h.
#pragma once

#include "haptics/device/arm/arm_dynamics.h"
#include "haptics/device/arm/stick_slip.h"
#include "haptics/device/simulated/human_impedance.h"

namespace fulcrum {

/// A hand that holds the handle; SI. The turning values are those of SimulatedHand.
struct HandGrip {
    HumanImpedance push = kPosture;
    double inertia_kg_m2 = 0.003;            ///< 0 to 1
    double turn_stiffness_Nm_per_rad = 3.0;  ///< 0 to 100
    double turn_damping_Nms_per_rad = 0.1;   ///< 0 to 10
    double strongest_N = 200.0;              ///< 0 to 1000
    double strongest_Nm = 10.0;              ///< 0 to 100
};
/// The handle is let go.
inline constexpr HandGrip kNoGrip{kNobody, 0.0, 0.0, 0.0, 0.0, 0.0};

/// Where the hand wants the handle, base frame.
struct GripTarget {
    Pose pose_B{};
    Vector3 velocity_B{Vector3::Zero()};
};

/// What one step changes.
struct ArmState {
    JointVector angle_rad;
    JointVector speed_rad_per_s;
    JointHolds holds{};  ///< what the joints did in the last step
};

/// What an arm's steps share: reserved once, so that a step allocates nothing.
class ArmMotion {
  public:
    explicit ArmMotion(const ArmModel& model);

    /// Another hand; its values as in HandGrip.
    void hold(const HandGrip& grip) noexcept { grip_ = grip; }
    [[nodiscard]] const HandGrip& grip() const noexcept { return grip_; }
    /// Moves `state` on by `dt_s` > 0 under a constant joint torque (n newton metres) and the hand.
    StickSlipCount step(const JointVector& torque_Nm, const GripTarget& target, double dt_s,
                        ArmState& state) noexcept;

    /// The energy of what moves (arm, rotors, what the hand adds) and of its weight, joules.
    [[nodiscard]] double compute_energy_J(const ArmState& state) const noexcept;
    /// The hand's spring at `state`, joules; without the bound on its force.
    [[nodiscard]] double compute_grip_energy_J(const ArmState& state,
                                               const GripTarget& target) const noexcept;

  private:
    [[nodiscard]] HeldMass held() const noexcept;
    void add_grip(const GripTarget& target, const JointVector& v, double dt_s) noexcept;

    ArmModel model_;
    ArmTwists twists_;
    JointMatrix rotors_;
    HandGrip grip_{};
    // One step's, in the order in which they are computed.
    ArmPosture posture_;
    ArmBodies bodies_;
    JointVector push_Nm_;  // all that does not wait for the mean velocity
    StickSlipProblem problem_;
};

}  // namespace fulcrum
