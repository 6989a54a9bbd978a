// Where an arm's links are at given joint angles, and what a hand at the handle has to do with the joints.
//
//   v_h = J v        J, 6 x n: rows 0 to 2 metres per second of the handle's origin, rows 3 to 5 radians per second
//   column i of J:   z_i x (p_h - p_i), z_i           z_i, p_i the joint's axis and a point of it, base frame B
//   torque = J^T (f, tau)                             what a wrench at the handle is at the joints
//
// Thread: any. Cost: about 0.3 us for seven joints.
// Source: Spong, Hutchinson, Vidyasagar 2006 (arm_model.h), sections 3.2 and 4.6: the geometric Jacobian.
#pragma once

#include "haptics/device/arm/arm_model.h"

namespace fulcrum {

/// Columns of joints that the arm has not are zero.
using HandleJacobian = Matrix<double, 6, kMostJoints>;

/// What the links' twists, alpha, give at every posture.
struct LinkTwist {
    double cosine = 1.0;
    double sine = 0.0;
};
using ArmTwists = std::array<LinkTwist, kMostJoints>;
[[nodiscard]] ArmTwists compute_twists(const ArmModel& model) noexcept;

struct ArmPosture {
    int n = 0;
    /// Frame i of arm_model.h in the base frame; frame 0 is the base.
    std::array<Matrix3, kMostJoints + 1> turn_B;
    std::array<Vector3, kMostJoints + 1> origin_B;
    Pose handle_B{};
    HandleJacobian jacobian_B;

    [[nodiscard]] Vector3 axis_B(int joint) const {
        return turn_B[static_cast<std::size_t>(joint)].col(2);
    }
};

/// At the angles `q` (n radians); `twists` of the same model.
void compute_posture(const ArmModel& model, const ArmTwists& twists, const JointVector& q,
                     ArmPosture& posture) noexcept;
void compute_posture(const ArmModel& model, const JointVector& q, ArmPosture& posture) noexcept;

/// What the joints' velocities (radians per second) are at the handle: J v.
[[nodiscard]] Vector6 compute_motion_B(const ArmPosture& posture, const JointVector& v) noexcept;

/// A wrench at the handle, along the base's axes, as one column.
[[nodiscard]] inline Vector6 stack(const Wrench& wrench) noexcept {
    Vector6 column;
    column << wrench.force, wrench.torque;
    return column;
}

}  // namespace fulcrum
