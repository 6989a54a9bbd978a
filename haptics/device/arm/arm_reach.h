// What an arm can promise a hand wherever it is in its workspace: found once, when the arm is built.
//
//   |T^-T (g + J_v^T f + J_w^T tau)|_k <= most_k  for every f, tau with |f| <= F, |tau| <= N, each motor k
//   F = min_k (most_k - |T^-T g|_k) / (2 |row k of T^-T J_v^T|)        N likewise with J_w
// so half of what a motor has besides the weight is for the force and half for the torque, and both may be full at once, in
// any direction. Over places in a ball about the home posture's handle and turns of the handle: where they are worst, and a
// little less, for between the samples and for a posture that friction holds a little beside its own.
//   damping   least of 1 / lambda_max(J_v D^-1 J_v^T), D the joints' viscous friction: no way of moving the handle at 1 m/s
//             loses less power; mass likewise with M, its mean over directions, at home
// Each place's posture is the one in which the arm's computer would leave it (arm_control.h): J delta = error, and the rest
// of delta brings the joints home, orthogonal in M.
//
// Thread: load path. Cost: about 10 ms.
// Source: the bounds are T^-T g + rows times a ball, by Cauchy and Schwarz; B. Siciliano, L. Sciavicco, L. Villani, G. Oriolo
// 2009, Robotics: modelling, planning and control, section 3.7: inverse kinematics by the Jacobian.
#pragma once

#include "haptics/device/arm/arm_dynamics.h"

namespace fulcrum {

/// Where the hand is to be served; SI.
struct ArmWorkspace {
    JointVector home_rad;    ///< n angles, within the stops; the workspace is about its handle
    double radius_m = 0.12;  ///< 0.01 to 0.5
    double tilt_rad = 0.5;   ///< the handle's turn about any axis, 0 to 1
};

struct ArmReach {
    double force_N = 0.0;    ///< F
    double torque_Nm = 0.0;  ///< N
    double damping_Ns_per_m = 0.0;
    double mass_kg = 0.0;
    double step_m =
        0.0;  ///< the most that one count of one encoder moves the handle; 0 without encoders
};

/// Refuses a workspace that the arm cannot reach, or where it cannot carry its own weight.
[[nodiscard]] Expected<ArmReach> compute_reach(const ArmModel& model,
                                               const ArmWorkspace& workspace);

}  // namespace fulcrum
