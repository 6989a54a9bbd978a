// The equation of motion of a serial arm, and of what is held at its handle.
//
//   M(q) a + c(q, v) + g(q) = torque + J^T wrench
//   M  joint-space inertia, with the rotors', symmetric and positive definite
//   c  centrifugal and Coriolis torque       g  what holds the arm against its weight
// All bodies are expressed in one frame, the base's, about its origin, so that no transform lies between two links:
//   s_i = (z_i, p_i x z_i)           V_i = V_i-1 + s_i v_i         A_i = A_i-1 + s_i a_i + V_i x s_i v_i
//   F_i = I_i A_i + V_i x* I_i V_i   torque_i = s_i . (F_i + ... + F_n) + rotors
//   M_ji = s_j . (I_i + ... + I_n) s_i    for j <= i
// What a hand holds fast, its own mass and inertia, rides on the last link. A person carries it: it has no weight here.
//
// Thread: any. Cost: about 1 us each for seven joints.
// Source: R. Featherstone 2008, Rigid body dynamics algorithms: table 5.1 (recursive Newton-Euler, after J. Luh, M. Walker,
// R. Paul 1980), table 6.2 (composite rigid body), in absolute coordinates as its section 5.3 says.
#pragma once

#include "haptics/device/arm/arm_posture.h"

namespace fulcrum {

/// What the hand adds at the handle; a ball, so that no turn of it matters.
struct HeldMass {
    double mass_kg = 0.0;
    double inertia_kg_m2 = 0.0;
};

/// A body's inertia about the base's origin, along the base's axes.
struct SpatialInertia {
    double mass_kg = 0.0;
    Vector3 moment_kg_m{Vector3::Zero()};    ///< mass times centre
    Matrix3 turning_kg_m2{Matrix3::Zero()};  ///< about the base's origin
};

/// The bodies of an arm at a posture: what the functions below share.
struct ArmBodies {
    std::array<SpatialInertia, kMostJoints> links;  ///< what is held included in the last
};

void compute_bodies(const ArmModel& model, const ArmPosture& posture, const HeldMass& held,
                    ArmBodies& bodies) noexcept;

/// M, n x n; `rotors` from compute_rotor_inertia.
[[nodiscard]] JointMatrix compute_joint_inertia(const ArmPosture& posture, const ArmBodies& bodies,
                                                const JointMatrix& rotors) noexcept;

/// M a + c for velocities `v` and accelerations `a`, n each; without weight.
[[nodiscard]] JointVector compute_inverse_dynamics(const ArmPosture& posture,
                                                   const ArmBodies& bodies,
                                                   const JointMatrix& rotors, const JointVector& v,
                                                   const JointVector& a) noexcept;

/// c alone.
[[nodiscard]] JointVector compute_motion_torque(const ArmPosture& posture, const ArmBodies& bodies,
                                                const JointVector& v) noexcept;

/// g: the torque that holds the arm, without what is held, against its weight.
[[nodiscard]] JointVector compute_weight_torque(const ArmModel& model,
                                                const ArmPosture& posture) noexcept;

}  // namespace fulcrum
