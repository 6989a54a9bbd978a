// What the arm's own computer tells the motors: hold the arm's weight, show the hand a wrench, keep the elbow up.
//
//   torque = g(q) + s J^T w + u N^T M a_0       q as the encoders count it
//   a_0 = -omega^2 (q - q_home) - 2 omega v     a critically damped swing back to the home posture
//   N^T = 1 - J^T Jbar^T,  Jbar^T = (J M^-1 J^T + epsilon)^-1 J M^-1
// N^T leaves of a torque what does not accelerate the handle: the elbow comes home without the hand feeling it (of the joints'
// friction on that way it feels a little). `epsilon`
// keeps the inverse finite in a singular posture, where the handle cannot move in some direction anyway.
// No motor is asked for more than it can give for ever. The weight comes first; then the wrench, scaled by the largest
// s <= 1 that fits, as a whole, so that its direction stays; then the posture with the largest u <= 1 that still fits.
//
// Thread: any. Cost: about 1 us for seven joints.
// Source: O. Khatib 1987, A unified approach for motion and force control of robot manipulators: the operational space
// formulation, IEEE J. Robotics and Automation 3(1), section VIII: the dynamically consistent inverse.
#pragma once

#include "haptics/device/arm/arm_dynamics.h"

namespace fulcrum {

/// SI.
struct ArmControlSettings {
    JointVector home_rad;        ///< n angles
    double posture_per_s = 3.0;  ///< omega, 0 (none) to 20
};

/// What one step asks of the motors.
struct ArmCommand {
    JointVector torque_Nm;       ///< at the joints
    double wrench_share = 1.0;   ///< s
    double posture_share = 1.0;  ///< u
};

class ArmControl {
  public:
    ArmControl(const ArmModel& model, const ArmControlSettings& settings);

    /// From angles and velocities of the joints (n each), the posture at these angles, and a finite wrench at the handle, base frame.
    [[nodiscard]] ArmCommand step(const ArmPosture& posture, const JointVector& q,
                                  const JointVector& v, const Wrench& wrench_B) noexcept;
    /// What the motors must give for a torque at the joints.
    [[nodiscard]] JointVector compute_motor_torque(const JointVector& torque_Nm) const noexcept {
        return multiply(motor_per_joint_, torque_Nm);
    }
    /// The largest part, 0 to 1, of `more` that the motors can give besides `given`, both at the motors.
    [[nodiscard]] double compute_share(const JointVector& given,
                                       const JointVector& more) const noexcept;

  private:
    [[nodiscard]] JointVector compute_posture_torque(const ArmPosture& posture,
                                                     const JointVector& q,
                                                     const JointVector& v) noexcept;

    ArmModel model_;
    ArmControlSettings settings_;
    JointMatrix rotors_;
    JointMatrix motor_per_joint_;  // T^-T
    ArmBodies bodies_;             // one step's
};

}  // namespace fulcrum
