// What a serial arm of turning joints is made of: a table, and what drives it.
//
//   X_(i-1,i) = Rz(q_i + theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i)     frame i is fixed to link i, i = 1 .. n
//   X_Bh = X_01 X_12 ... X_(n-1,n) X_nh                           B the arm's base, h the handle
// Joint i turns about the z axis of frame i-1. Motors and joints are coupled by a transmission T, in radians:
//   angle_motor = T q        torque_joint = T^T torque_motor        inertia at the joints = T^T diag(rotor) T
// Two motors of a cable differential share two joints, so what one joint may have depends on what the other is given.
// The gyroscopic torque of a rotor that is carried about is left out.
//
// Thread: any; plain data. Cost: none.
// Source: J. Denavit, R. Hartenberg 1955, A kinematic notation for lower-pair mechanisms based on matrices, J. Applied
// Mechanics 22, in the form of M. Spong, S. Hutchinson, M. Vidyasagar 2006, Robot modeling and control, eq. 3.10.
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/arm/joint_matrix.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstddef>

namespace fulcrum {

/// A link and the joint before it.
struct ArmLink {
    double a_m = 0.0;
    double alpha_rad = 0.0;
    double d_m = 0.0;
    double theta_rad = 0.0;
    double mass_kg = 0.0;               ///< 0 or more
    Vector3 centre_m{Vector3::Zero()};  ///< of mass, in the link's frame
    Matrix3 inertia_kg_m2{
        Matrix3::Zero()};   ///< about the centre of mass, along the link's axes; symmetric
    double low_rad = -1.0;  ///< the joint's stops
    double high_rad = 1.0;
    double dry_friction_Nm = 0.0;      ///< Coulomb's, at the joint, 0 or more
    double damping_Nms_per_rad = 0.0;  ///< viscous friction at the joint, above 0
};

/// A motor.
struct ArmMotor {
    double rotor_inertia_kg_m2 = 0.0;  ///< with all that turns at its speed, 0 or more
    double max_torque_Nm = 1.0;        ///< that it can give for ever, above 0
    double counts_per_turn = 0.0;      ///< of its encoder; 0 for none
};

struct ArmModel {
    int n = 0;  ///< joints, and motors, 1 to kMostJoints
    std::array<ArmLink, kMostJoints> links{};
    std::array<ArmMotor, kMostJoints> motors{};
    JointMatrix transmission;                     ///< T, n x n, invertible
    Pose handle{};                                ///< X_nh
    Vector3 gravity_B{Vector3(0.0, 0.0, -9.81)};  ///< metres per second squared
};

/// Refuses a model outside the ranges named above, without inertia somewhere, or that is not finite.
[[nodiscard]] Expected<void> validate(const ArmModel& model);

/// T^T diag(rotor) T, n x n, kg m^2.
[[nodiscard]] JointMatrix compute_rotor_inertia(const ArmModel& model);

/// T^-1, n x n: radians of each joint a radian of each motor.
[[nodiscard]] JointMatrix compute_joint_per_motor(const ArmModel& model);

}  // namespace fulcrum
