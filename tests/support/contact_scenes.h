// Small contact problems with answers known in closed form, for every solver alike.
#pragma once

#include "haptics/constraint/complementarity.h"
#include "haptics/constraint/contact_solver.h"
#include "haptics/math/length.h"

#include <cmath>

namespace fulcrum::contact_scenes {

constexpr double kGravity = 9.81;
constexpr double kStep_s = 0.001;
// Of answers in m/s and N s of sizes about 0.01 to 1: solvers are asked for 1e-10.
constexpr double kSolved = 1.0e-8;

inline Matrix3 ball_inertia(double mass_kg, double radius_m) {
    return Matrix3::Identity() * (0.4 * mass_kg * radius_m * radius_m);
}
inline Matrix3 cube_inertia(double mass_kg, double edge_m) {
    return Matrix3::Identity() * (mass_kg * edge_m * edge_m / 6.0);
}
inline Vector6 moving(const Vector3& linear, const Vector3& angular = Vector3::Zero()) {
    Vector6 v;
    v << linear, angular;
    return v;
}

inline ContactSolverSettings settings_of(ContactMethod method,
                                         FrictionShape shape = FrictionShape::cone) {
    ContactSolverSettings settings;
    settings.method = method;
    settings.friction_shape = shape;
    settings.tolerance_m_per_s = 1.0e-10;
    settings.max_iterations = method == ContactMethod::iterative ? 10000 : 60;
    return settings;
}

inline SolveReport solve(ContactProblem& problem, const ContactSolverSettings& settings) {
    ContactSolver solver(settings, problem.capacity());
    return solver.solve(problem);
}

/// A contact at `point`, bodies' centres at `centre_a`, `centre_b`.
inline ContactConstraint contact_at(int body_a, const Vector3& centre_a, int body_b,
                                    const Vector3& centre_b, const Vector3& point,
                                    const Vector3& normal, double friction = 0.0) {
    ContactConstraint c;
    c.body_a = body_a;
    c.body_b = body_b;
    c.arm_a = point - centre_a;
    c.arm_b = point - centre_b;
    c.axes_W = make_contact_axes(normal);
    c.static_friction = c.dynamic_friction = friction;
    return c;
}

/// A row of no bounds between two bodies, each by what its twist counts for.
inline RowConstraint tie(int body_a, const Vector6& along_a, int body_b, const Vector6& along_b) {
    RowConstraint row;
    row.body_a = body_a;
    row.body_b = body_b;
    row.jacobian_a = along_a;
    row.jacobian_b = along_b;
    row.least = -HUGE_VAL;
    row.most = HUGE_VAL;
    return row;
}
/// One against the ground.
inline RowConstraint tie_down(int body, const Vector6& along) {
    return tie(kGround, Vector6::Zero(), body, along);
}
/// Of the three rows that hold a point of one body to a point of another, the one along an axis.
inline RowConstraint hold_along(const Vector3& axis, int body_a, const Vector3& arm_a, int body_b,
                                const Vector3& arm_b) {
    return tie(body_a, -moving(axis, arm_a.cross(axis)), body_b, moving(axis, arm_b.cross(axis)));
}

/// A ball of 1 kg that two walls push apart at 0.5 m/s each: no answer.
inline ContactProblem squeezed_ball(double impulse_Ns) {
    ContactProblem problem({1, 2, 0});
    problem.add_body(1.0, ball_inertia(1.0, 0.1), Vector6::Zero());
    for (const double side : {-1.0, 1.0}) {
        const Vector3 normal = side * Vector3::UnitX();
        ContactConstraint c =
            contact_at(kGround, Vector3::Zero(), 0, Vector3::Zero(), -0.1 * normal, normal);
        c.target_m_per_s.x() = 0.5;
        c.impulse_Ns.x() = impulse_Ns;
        problem.add_contact(c);
    }
    return problem;
}

/// The greatest difference of any two of their numbers.
inline double find_apart(const Vector6& a, const Vector6& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

/// The four lower corners of a cube on the ground, whose normal is the first of `axes`.
inline void add_corners(ContactProblem& problem, int body, double edge_m, double friction,
                        const Matrix3& axes, double dynamic_friction = -1.0) {
    for (int corner = 0; corner < 4; ++corner) {
        ContactConstraint c;
        c.body_b = body;
        c.axes_W = axes;
        c.arm_b =
            axes * (0.5 * edge_m *
                    Vector3(-1.0, (corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0));
        c.static_friction = friction;
        c.dynamic_friction = dynamic_friction < 0.0 ? friction : dynamic_friction;
        problem.add_contact(c);
    }
}

/// What all contacts of the problem push in the world, N s.
inline Vector3 sum_of_impulses(const ContactProblem& problem) {
    Vector3 sum = Vector3::Zero();
    for (const ContactConstraint& c : problem.contacts()) {
        sum += c.axes_W * c.impulse_Ns;
    }
    return sum;
}

/// Linear and angular momentum about the origin, bodies at these places.
inline Vector6 total_momentum(const ContactProblem& problem, std::span<const Vector3> places,
                              bool free) {
    Vector6 total = Vector6::Zero();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const ConstrainedBody& body = problem.bodies()[i];
        const Vector6& v = free ? body.free_velocity_W : body.velocity_W;
        const Vector3 linear = body.mass_kg * v.head<3>();
        total.head<3>() += linear;
        total.tail<3>() += places[i].cross(linear) + body.inertia_W * v.tail<3>();
    }
    return total;
}

}  // namespace fulcrum::contact_scenes
