#include "haptics/dynamics/hand_rows.h"

#include "haptics/math/length.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// Of the body's own: a virtual mass of less is none, and the force is given as it is.
constexpr double kLeastVirtual = 1.0e-6;
// Of what the damper of a push gives, as its bound: without force it gives none.
constexpr double kMostDamped = 2.0;

Vector3 cut_to(double most, const Vector3& v) noexcept {
    const double length = compute_length(v);
    return length > most ? Vector3(most / length * v) : v;
}

Vector3 find_held_velocity(const RigidState& state, const Vector3& at_W) noexcept {
    return state.velocity_W.linear + state.velocity_W.angular.cross(at_W - state.pose_W.position);
}

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
    const double impulse = dt_s * axis.force;
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

// What friction bears across a push, and all of it.
struct ForceBounds {
    bool is_grip = false;
    double across_N = 0.0;
    double most_N = 0.0;

    // The nearest that the bounds let; along the first axis and across it.
    [[nodiscard]] Vector3 cut(Vector3 force) const noexcept {
        if (!is_grip) {
            const Vector3 across = cut_to(across_N, {0.0, force.y(), force.z()});
            force = {std::max(force.x(), 0.0), across.y(), across.z()};
        }
        return cut_to(most_N, force);
    }
};

ForceBounds find_force_bounds(const PushBounds& bounds) noexcept {
    const bool is_grip = bounds.along_W.isZero(0.0);
    return {is_grip, is_grip ? bounds.most_N : std::min(bounds.friction_N, bounds.most_N),
            bounds.most_N};
}

// The spring's part of a push, and that of its damper: each has the share of the force and of its bound that it has of the virtual mass.
void add_press(HeldAxis axis, double spring_kg, double most_N, const RigidState& state, double dt_s,
               HandRows& rows) noexcept {
    const double share = axis.mass > 0.0 ? spring_kg / axis.mass : 1.0;
    const double damped_N = (1.0 - share) * axis.force;
    const double damping_kg = axis.mass - spring_kg;
    axis.force *= share;
    axis.most = share * most_N;
    axis.mass = spring_kg;
    add_axis(axis, state, dt_s, rows);
    axis.force = damped_N;
    axis.most = std::min(kMostDamped * damped_N, (1.0 - share) * most_N);
    axis.mass = damping_kg;
    add_axis(axis, state, dt_s, rows);
}

void add_force(const BodyHold& hold, const Inertia& inertia, const RigidState& state, double dt_s,
               HandRows& rows) noexcept {
    const PushSlopes& slopes = hold.slopes;
    const ForceBounds bounds = find_force_bounds(hold.bounds);
    const Matrix3 axes =
        bounds.is_grip ? Matrix3(Matrix3::Identity()) : make_contact_axes(hold.bounds.along_W);
    const Vector3 arm = hold.at_W - state.pose_W.position;
    const double k_dt = dt_s * slopes.stiffness_N_per_m;
    const Vector3 force = bounds.cut(
        axes.transpose() * (hold.push_W.force - k_dt * find_held_velocity(state, hold.at_W)));
    const double mass_kg = dt_s * (k_dt + slopes.damping_Ns_per_m) + slopes.late_mass_kg;
    int n_along = 0;
    for (int i = 0; i < 3; ++i) {
        HeldAxis axis{.force = force[i],
                      .least = -bounds.across_N,
                      .most = bounds.across_N,
                      .mass = mass_kg,
                      .own = inertia.mass_kg};
        axis.jacobian << axes.col(i), arm.cross(axes.col(i));
        if (!bounds.is_grip && i == 0) {
            axis.least = 0.0;
            add_press(axis, dt_s * k_dt, bounds.most_N, state, dt_s, rows);
            n_along = rows.count;
        } else {
            add_axis(axis, state, dt_s, rows);
        }
    }
    rows.balls[0] = {n_along, rows.count - n_along, 0, dt_s * bounds.across_N};
    rows.balls[1] = {0, rows.count, n_along, dt_s * bounds.most_N};
}

void add_couple(const BodyHold& hold, const Inertia& inertia, const RigidState& state, double dt_s,
                HandRows& rows) noexcept {
    const PushSlopes& slopes = hold.slopes;
    const double most_Nm = hold.bounds.most_Nm;
    const double k_dt = dt_s * slopes.turn_stiffness_Nm_per_rad;
    const Vector3 couple = cut_to(most_Nm, hold.push_W.torque - k_dt * state.velocity_W.angular);
    const double moment_kg_m2 = dt_s * (k_dt + slopes.turn_damping_Nms_per_rad);
    const int first = rows.count;
    for (int i = 0; i < 3; ++i) {
        HeldAxis axis{.force = couple[i],
                      .least = -most_Nm,
                      .most = most_Nm,
                      .mass = moment_kg_m2,
                      .own = inertia.moments_kg_m2.minCoeff()};
        axis.jacobian[3 + i] = 1.0;
        add_axis(axis, state, dt_s, rows);
    }
    rows.balls[2] = {first, rows.count - first, 0, dt_s * most_Nm};
}

}  // namespace

HandRows make_hand_rows(const BodyHold& hold, const Inertia& inertia, const RigidState& state,
                        double dt_s) noexcept {
    HandRows rows;
    add_force(hold, inertia, state, dt_s, rows);
    add_couple(hold, inertia, state, dt_s, rows);
    return rows;
}

void carry_hold(const RigidState& before, const RigidState& after, BodyHold& hold) noexcept {
    const PushSlopes& slopes = hold.slopes;
    const Vector3 at_W = after.pose_W * (before.pose_W.inverse() * hold.at_W);
    const Vector3 sped_up = find_held_velocity(after, at_W) - find_held_velocity(before, hold.at_W);
    const Vector3 turned =
        compute_log(after.pose_W.orientation * before.pose_W.orientation.conjugate());
    hold.push_W.force -=
        slopes.stiffness_N_per_m * (at_W - hold.at_W) + slopes.damping_Ns_per_m * sped_up;
    hold.push_W.torque -=
        slopes.turn_stiffness_Nm_per_rad * turned +
        slopes.turn_damping_Nms_per_rad * (after.velocity_W.angular - before.velocity_W.angular);
    hold.at_W = at_W;
}

}  // namespace fulcrum
