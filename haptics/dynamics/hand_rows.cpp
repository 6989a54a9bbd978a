#include "haptics/dynamics/hand_rows.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// Of the body's own: a virtual mass of less is none, and the force is given as it is.
constexpr double kLeastVirtual = 1.0e-6;

// One axis of a hold.
struct HeldAxis {
    Vector6 jacobian = Vector6::Zero();
    double force = 0.0;  // along it
    double least = 0.0;  // force
    double most = 0.0;
    double mass = 0.0;  // virtual
    double own = 0.0;
};

void add_axis(const HeldAxis& axis, const RigidState& state, double dt_s, HandRows& rows) noexcept {
    if (!(axis.most > axis.least)) {
        return;
    }
    Vector6 before;
    before << state.velocity_W.linear, state.velocity_W.angular;
    const double impulse = dt_s * std::clamp(axis.force, axis.least, axis.most);
    if (!(axis.mass > kLeastVirtual * axis.own)) {
        rows.rows[static_cast<std::size_t>(rows.count++)] = {
            .jacobian_b = axis.jacobian, .least = impulse, .most = impulse, .impulse = impulse};
        return;
    }
    const double softness = 1.0 / axis.mass;
    rows.rows[static_cast<std::size_t>(rows.count++)] = {
        .jacobian_b = axis.jacobian,
        .target = axis.jacobian.dot(before) + impulse * softness,
        .least = dt_s * axis.least,
        .most = dt_s * axis.most,
        .softness = softness,
        .impulse = impulse};
}

}  // namespace

HandRows make_hand_rows(const BodyHold& hold, const Inertia& inertia, const RigidState& state,
                        double dt_s) noexcept {
    HandRows rows;
    const PushBounds& bounds = hold.bounds;
    const PushSlopes& slopes = hold.slopes;
    const bool is_grip = bounds.along_W.isZero(0.0);
    // Its force, along what it pushes and across.
    const Matrix3 axes = is_grip ? Matrix3(Matrix3::Identity()) : make_contact_axes(bounds.along_W);
    const Vector3 arm = hold.at_W - state.pose_W.position;
    const double mass_kg =
        dt_s * (dt_s * slopes.stiffness_N_per_m + slopes.damping_Ns_per_m) + slopes.late_mass_kg;
    for (int i = 0; i < 3; ++i) {
        HeldAxis axis{
            .force = axes.col(i).dot(hold.push_W.force), .mass = mass_kg, .own = inertia.mass_kg};
        axis.jacobian << axes.col(i), arm.cross(axes.col(i));
        axis.most = is_grip || i == 0 ? bounds.most_N : std::min(bounds.friction_N, bounds.most_N);
        axis.least = !is_grip && i == 0 ? 0.0 : -axis.most;
        add_axis(axis, state, dt_s, rows);
    }
    // Its couple.
    const double most_Nm =
        is_grip ? bounds.most_Nm : std::min(bounds.most_Nm, compute_length(hold.push_W.torque));
    const double moment_kg_m2 =
        dt_s * (dt_s * slopes.turn_stiffness_Nm_per_rad + slopes.turn_damping_Nms_per_rad);
    for (int i = 0; i < 3; ++i) {
        HeldAxis axis{.force = hold.push_W.torque[i],
                      .least = -most_Nm,
                      .most = most_Nm,
                      .mass = moment_kg_m2,
                      .own = inertia.moments_kg_m2.minCoeff()};
        axis.jacobian[3 + i] = 1.0;
        add_axis(axis, state, dt_s, rows);
    }
    return rows;
}

}  // namespace fulcrum
