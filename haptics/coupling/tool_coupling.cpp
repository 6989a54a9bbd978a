#include "haptics/coupling/tool_coupling.h"

#include "haptics/coupling/virtual_coupling.h"
#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// A curve at one stretch: its height and its slope there.
struct CurvePoint {
    double height = 0.0;
    double slope = 0.0;
};

// The turn's curve is the shift's with radians for metres and newton metres for newtons; its damper is apart.
CouplingSettings curve_of(const TurnCouplingSettings& turn) noexcept {
    return {.stiffness_N_per_m = turn.stiffness_Nm_per_rad,
            .linear_range_m = turn.linear_range_rad,
            .saturation_range_m = turn.saturation_range_rad,
            .saturation_force_N = turn.saturation_torque_Nm};
}

CurvePoint compute_curve(const CouplingSettings& curve, double clamp, double stretch) noexcept {
    if (clamp > 0.0 && stretch > clamp) {
        return {compute_spring_force_N(curve, clamp), 0.0};
    }
    return {compute_spring_force_N(curve, stretch), compute_spring_slope_N_per_m(curve, stretch)};
}

// A pull along `stretch` and its derivative by it: f' n n^T + (f/s) (I - n n^T).
struct Pull {
    Vector3 pull;
    Matrix3 by_stretch;
};

Pull compute_pull(const CouplingSettings& curve, double clamp, const Vector3& stretch) noexcept {
    const double length = compute_length(stretch);
    if (!(length > 0.0)) {
        const CurvePoint at = compute_curve(curve, clamp, 0.0);
        return {Vector3::Zero(), at.slope * Matrix3::Identity()};
    }
    const CurvePoint at = compute_curve(curve, clamp, length);
    const Vector3 direction = stretch / length;
    const double across = at.height / length;
    return {at.height * direction,
            across * Matrix3::Identity() + (at.slope - across) * direction * direction.transpose()};
}

Vector3 compute_turn(const MovingFrame& handle, const MovingFrame& grip) noexcept {
    return compute_log(handle.pose_W.orientation * grip.pose_W.orientation.conjugate());
}

Vector3 compute_plain_pull(const CouplingSettings& curve, double clamp,
                           const Vector3& stretch) noexcept {
    const double length = compute_length(stretch);
    return length > 0.0 ? Vector3(stretch * (compute_curve(curve, clamp, length).height / length))
                        : Vector3(Vector3::Zero());
}

// B_r s: the spin's slip along the tool's axes, each braked by its own value.
Vector3 compute_turn_damping(const TurnCouplingSettings& turn, const MovingFrame& grip,
                             const Vector3& spin_slip_W) noexcept {
    const Quaternion& q_WT = grip.pose_W.orientation;
    return q_WT * Vector3(turn.damping_Nms_per_rad.cwiseProduct(q_WT.conjugate() * spin_slip_W));
}

}  // namespace

ToolCouplingSettings make_critically_damped(ToolCouplingSettings settings, double mass_kg,
                                            const Vector3& moments_kg_m2) noexcept {
    settings.shift.damping_Ns_per_m = 2.0 * std::sqrt(mass_kg * settings.shift.stiffness_N_per_m);
    settings.turn.damping_Nms_per_rad =
        2.0 * (settings.turn.stiffness_Nm_per_rad * moments_kg_m2).cwiseSqrt();
    return settings;
}

double compute_shift_energy_J(const ToolCouplingSettings& settings, double stretch_m) noexcept {
    const double bent_m =
        settings.clamp_m > 0.0 ? std::min(stretch_m, settings.clamp_m) : stretch_m;
    return compute_spring_energy_J(settings.shift, bent_m) +
           (stretch_m - bent_m) * compute_spring_force_N(settings.shift, bent_m);
}

Wrench compute_tool_coupling(const ToolCouplingSettings& settings, const MovingFrame& handle,
                             const MovingFrame& grip) noexcept {
    const Vector3 stretch_W = handle.pose_W.position - grip.pose_W.position;
    const Vector3 slip_W = grip.velocity_W.linear - handle.velocity_W.linear;
    const Vector3 spin_slip_W = grip.velocity_W.angular - handle.velocity_W.angular;
    return {compute_plain_pull(settings.shift, settings.clamp_m, stretch_W) -
                settings.shift.damping_Ns_per_m * slip_W,
            compute_plain_pull(curve_of(settings.turn), settings.clamp_rad,
                               compute_turn(handle, grip)) -
                compute_turn_damping(settings.turn, grip, spin_slip_W)};
}

ToolCouplingWrench compute_linearised_tool_coupling(const ToolCouplingSettings& settings,
                                                    const MovingFrame& handle,
                                                    const MovingFrame& grip) noexcept {
    const Vector3 slip_W = grip.velocity_W.linear - handle.velocity_W.linear;
    const Vector3 spin_slip_W = grip.velocity_W.angular - handle.velocity_W.angular;
    // The shift: d falls by what the grip moves.
    const Pull shift = compute_pull(settings.shift, settings.clamp_m,
                                    handle.pose_W.position - grip.pose_W.position);
    ToolCouplingWrench out;
    out.shift.force = shift.pull - settings.shift.damping_Ns_per_m * slip_W;
    out.shift.by_position = -shift.by_stretch;
    out.shift.by_velocity = -settings.shift.damping_Ns_per_m * Matrix3::Identity();
    // The turn: phi' = log(exp(phi) exp(-dtheta)) = phi - J_r(phi)^-1 dtheta.
    const Vector3 turn = compute_turn(handle, grip);
    const Pull pull = compute_pull(curve_of(settings.turn), settings.clamp_rad, turn);
    const Matrix3 R_WT = grip.pose_W.orientation.toRotationMatrix();
    const Matrix3 damping =
        R_WT * settings.turn.damping_Nms_per_rad.asDiagonal() * R_WT.transpose();
    const Vector3 damped = compute_turn_damping(settings.turn, grip, spin_slip_W);
    out.torque = pull.pull - damped;
    // The damper's axes turn with the tool: d(-B s) = ([B s] - B [s]) dtheta.
    out.torque_by_turn = -pull.by_stretch * compute_right_jacobian_inverse(turn) +
                         compute_skew(damped) - damping * compute_skew(spin_slip_W);
    out.torque_by_spin = -damping;
    return out;
}

}  // namespace fulcrum
