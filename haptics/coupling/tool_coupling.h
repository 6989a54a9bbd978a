// The link between a handle that is held in six degrees of freedom and the simulated tool: a spring and a damper for the
// shift, and a pair for the turn.
//
//   F   = f(|d|) d/|d| - b (v_T - v_H)                 d   = p_H - p_T
//   tau = g(|phi|) phi/|phi| - B_r (w_T - w_H)         phi = log(q_H q_T^-1), |phi| <= pi;  B_r = R diag(b_1, b_2, b_3) R^T
// F and tau act on the tool at its grip; the hand feels -F and -tau there. f is the curve of virtual_coupling.h: k s,
// or linear, a cubic, constant; g is the same curve over radians. With a clamp c > 0 the spring's force stays at
// f(c) beyond a stretch of c: voxel sampling clamps at half a voxel, so that no stretch pulls the tool through a field
// of that depth; g is clamped likewise. At |phi| = pi the shorter way round changes sides and tau jumps.
// Both dampers see relative velocities: a handle that moves evenly in free space feels nothing (a drag of 0 once the
// tool follows, whatever k and b). What it feels while it speeds up is the tool's mass.
// The turn's damper has a value for each of the tool's axes, R its orientation: where those are its principal axes, each can be
// critically damped, b = 2 sqrt(m k), b_i = 2 sqrt(I_i k_r). One value for all would ring about some axes or creep about others.
//
// Thread: haptic loop. Cost: about 50 ns; with derivatives about 100 ns; no allocation.
// Source: W. McNeely, K. Puterbaugh, J. Troy 1999, Six degree-of-freedom haptic rendering using voxel sampling, sections
// 5.1 and 5.2 (law, clamp); M. Otaduy, M. Lin 2005, sections 5.1 to 5.3.1 (derivatives, saturation); M. Wan, W. McNeely
// 2003. The damper along the axes and the derivatives are ours, for q_T <- exp(dtheta) q_T: dphi = -J_r(phi)^-1 dtheta, and with
// s = w_T - w_H,  d(-B_r s) = ([B_r s] - B_r [s]) dtheta.
#pragma once

#include "haptics/base/error.h"
#include "haptics/coupling/coupling_settings.h"
#include "haptics/math/rotation.h"
#include "haptics/math/wrench_jacobian.h"

#include <algorithm>
#include <span>

namespace fulcrum {

/// The half that answers a turn. With the last three fields zero the spring is linear up to pi.
struct TurnCouplingSettings {
    double stiffness_Nm_per_rad = 0.5;  ///< 0 to 1e3; 500 N/m at an arm of 32 mm
    /// Along the tool's axes, 0 to 100 each. The default is critical for moments of 2.4e-6 kg m^2: a ball of 10 g, 24 mm.
    Vector3 damping_Nms_per_rad{2.2e-3, 2.2e-3, 2.2e-3};
    double linear_range_rad = 0.0;      ///< 0 or more
    double saturation_range_rad = 0.0;  ///< above linear_range_rad, or 0
    double saturation_torque_Nm = 0.0;  ///< the constant; at least what keeps the cubic rising
};

/// Fixed at load.
struct ToolCouplingSettings {
    /// The half that answers a shift; the default damping is critical for a tool of 10 g.
    CouplingSettings shift{.stiffness_N_per_m = 500.0, .damping_Ns_per_m = 4.472};
    TurnCouplingSettings turn{};
    double clamp_m =
        0.0;  ///< half a voxel for voxel sampling, 0 for none; 0 to 1, not with saturation
    double clamp_rad = 0.0;  ///< the same of the turn; 0 to pi
};

/// Refuses settings outside the ranges named at each field, NaN included, a saturating part that would fall, and a
/// clamp together with saturation.
[[nodiscard]] Expected<void> validate(const ToolCouplingSettings& settings);

/// `settings` with both dampers critical for a tool of `mass_kg` and the moments of inertia `moments_kg_m2` about its axes, on the
/// stiffnesses as they stand: b = 2 sqrt(m k), b_i = 2 sqrt(I_i k_r).
[[nodiscard]] ToolCouplingSettings make_critically_damped(ToolCouplingSettings settings,
                                                          double mass_kg,
                                                          const Vector3& moments_kg_m2) noexcept;

/// What the shift's spring holds at that stretch, J; beyond a clamp the force stays and the energy goes on.
[[nodiscard]] double compute_shift_energy_J(const ToolCouplingSettings& settings,
                                            double stretch_m) noexcept;

/// A frame that moves: the handle, or the tool's grip. World frame.
struct MovingFrame {
    Pose pose_W{};
    Twist velocity_W{};
};

[[nodiscard]] inline bool is_finite(const MovingFrame& frame) noexcept {
    return is_finite(frame.pose_W) && frame.velocity_W.linear.allFinite() &&
           frame.velocity_W.angular.allFinite();
}
[[nodiscard]] inline bool are_finite(std::span<const MovingFrame> frames) noexcept {
    return std::ranges::all_of(frames, [](const MovingFrame& one) { return is_finite(one); });
}

/// Of a place that moves with the frame.
[[nodiscard]] inline Vector3 compute_velocity_at(const MovingFrame& frame,
                                                 const Vector3& place_W) noexcept {
    return frame.velocity_W.linear +
           frame.velocity_W.angular.cross(place_W - frame.pose_W.position);
}

/// The frame so much later, moved evenly along its velocity; `later_s` may be negative.
[[nodiscard]] inline MovingFrame move_evenly(const MovingFrame& frame, double later_s) noexcept {
    MovingFrame moved = frame;
    moved.pose_W.position += later_s * frame.velocity_W.linear;
    moved.pose_W.orientation =
        compute_exp(later_s * frame.velocity_W.angular) * frame.pose_W.orientation;
    return moved;
}

/// The wrench on the tool about its grip, and how its force depends on the grip's place and velocity, its torque on the
/// tool's turn (left perturbation) and spin.
struct ToolCouplingWrench {
    PointForce shift;
    Vector3 torque{Vector3::Zero()};          ///< Nm
    Matrix3 torque_by_turn{Matrix3::Zero()};  ///< Nm/rad
    Matrix3 torque_by_spin{Matrix3::Zero()};  ///< Nms/rad
};

/// Force (N) and torque (Nm, about the grip) on the tool, world frame. The hand feels the opposite.
[[nodiscard]] Wrench compute_tool_coupling(const ToolCouplingSettings& settings,
                                           const MovingFrame& handle,
                                           const MovingFrame& grip) noexcept;
/// The same with its derivatives.
[[nodiscard]] ToolCouplingWrench compute_linearised_tool_coupling(
    const ToolCouplingSettings& settings, const MovingFrame& handle,
    const MovingFrame& grip) noexcept;

}  // namespace fulcrum
