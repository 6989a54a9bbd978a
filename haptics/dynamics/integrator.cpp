#include "haptics/dynamics/integrator.h"

#include "haptics/math/rotation.h"

#include <cmath>
#include <utility>

namespace fulcrum {
namespace {

// What one step needs to know.
struct Problem {
    const Inertia& inertia;
    const Load& load;
    double time_s;
    double dt_s;

    [[nodiscard]] Wrench compute_wrench(const RigidState& state, double at_s) const noexcept {
        Wrench wrench;
        load.add_wrench(state, at_s, wrench);
        return wrench;
    }
};

void step_explicit_euler(const Problem& problem, const RigidState& state,
                         RigidState& next) noexcept {
    const double h = problem.dt_s;
    const Wrench wrench = problem.compute_wrench(state, problem.time_s);
    const Vector3 momentum = compute_angular_momentum_W(problem.inertia, state) + h * wrench.torque;
    next.pose_W.position = state.pose_W.position + h * state.velocity_W.linear;
    next.pose_W.orientation = compute_exp(h * state.velocity_W.angular) * state.pose_W.orientation;
    next.velocity_W.linear = state.velocity_W.linear + h / problem.inertia.mass_kg * wrench.force;
    next.velocity_W.angular = compute_spin_W(problem.inertia, next.pose_W.orientation, momentum);
}

void step_semi_implicit_euler(const Problem& problem, const RigidState& state,
                              RigidState& next) noexcept {
    const double h = problem.dt_s;
    const Wrench wrench = problem.compute_wrench(state, problem.time_s);
    const Vector3 momentum = compute_angular_momentum_W(problem.inertia, state) + h * wrench.torque;
    const Quaternion& q = state.pose_W.orientation;
    next.velocity_W.linear = state.velocity_W.linear + h / problem.inertia.mass_kg * wrench.force;
    next.pose_W.position = state.pose_W.position + h * next.velocity_W.linear;
    next.pose_W.orientation = compute_exp(h * compute_spin_W(problem.inertia, q, momentum)) * q;
    next.velocity_W.angular = compute_spin_W(problem.inertia, next.pose_W.orientation, momentum);
}

void step_verlet(VerletVelocity estimate, const Problem& problem, const RigidState& state,
                 RigidState& next) noexcept {
    const Inertia& inertia = problem.inertia;
    const double half_s = 0.5 * problem.dt_s;
    const Vector3 momentum = compute_angular_momentum_W(inertia, state);
    // Half a drift; the old momenta.
    RigidState middle = state;
    middle.pose_W.position += half_s * state.velocity_W.linear;
    middle.pose_W.orientation =
        compute_free_turn(inertia, state.pose_W.orientation, momentum, half_s);
    const Quaternion& q = middle.pose_W.orientation;
    middle.velocity_W.angular = compute_spin_W(inertia, q, momentum);
    const double middle_s = problem.time_s + half_s;
    Wrench wrench = problem.compute_wrench(middle, middle_s);
    if (estimate == VerletVelocity::predicted_midpoint) {
        middle.velocity_W.linear += half_s / inertia.mass_kg * wrench.force;
        middle.velocity_W.angular = compute_spin_W(inertia, q, momentum + half_s * wrench.torque);
        wrench = problem.compute_wrench(middle, middle_s);
    }
    // The kick, and the other half of the drift.
    const Vector3 kicked = momentum + problem.dt_s * wrench.torque;
    next.velocity_W.linear =
        state.velocity_W.linear + problem.dt_s / inertia.mass_kg * wrench.force;
    next.pose_W.position = middle.pose_W.position + half_s * next.velocity_W.linear;
    next.pose_W.orientation = compute_free_turn(inertia, q, kicked, half_s);
    next.velocity_W.angular = compute_spin_W(inertia, next.pose_W.orientation, kicked);
}

StepResult step_by_name(const IntegratorSettings& settings, const Problem& problem,
                        const RigidState& state, RigidState& next) noexcept {
    switch (settings.integrator) {
        case Integrator::explicit_euler:
            step_explicit_euler(problem, state, next);
            break;
        case Integrator::semi_implicit_euler:
            step_semi_implicit_euler(problem, state, next);
            break;
        case Integrator::verlet:
            step_verlet(settings.verlet_velocity, problem, state, next);
            break;
        case Integrator::runge_kutta_4:
            step_runge_kutta_4(problem.inertia, problem.load, problem.time_s, problem.dt_s, state,
                               next);
            break;
        case Integrator::backward_euler:
            return step_backward_euler(settings, problem.inertia, problem.load, problem.time_s,
                                       problem.dt_s, state, next);
    }
    return {};
}

// Axes by their moments.
struct PrincipalOrder {
    int least = 0;
    int middle = 1;
    int most = 2;
};

PrincipalOrder order_axes(const Vector3& moments) noexcept {
    PrincipalOrder order;
    if (moments[order.least] > moments[order.middle]) {
        std::swap(order.least, order.middle);
    }
    if (moments[order.middle] > moments[order.most]) {
        std::swap(order.middle, order.most);
    }
    if (moments[order.least] > moments[order.middle]) {
        std::swap(order.least, order.middle);
    }
    return order;
}

}  // namespace

// The part of a ball with the middle moment is exact and leaves the momentum as the body sees it; the other two turn by what their
// rates exceed it by.
Quaternion compute_free_turn(const Inertia& inertia, const Quaternion& orientation,
                             const Vector3& momentum_W, double dt_s) noexcept {
    const Vector3& moments = inertia.moments_kg_m2;
    const PrincipalOrder order = order_axes(moments);
    const double middle_kg_m2 = moments[order.middle];
    Quaternion q = compute_exp(dt_s / middle_kg_m2 * momentum_W) * orientation;
    Vector3 momentum_B = orientation.conjugate() * momentum_W;
    const auto turn_about = [&](int axis, double time_s) noexcept {
        const double excess = (middle_kg_m2 - moments[axis]) / (moments[axis] * middle_kg_m2);
        const double half_rad = 0.5 * time_s * excess * momentum_B[axis];
        const double c = std::cos(half_rad);
        const double s = std::sin(half_rad);
        q = q * Quaternion(c, axis == 0 ? s : 0.0, axis == 1 ? s : 0.0, axis == 2 ? s : 0.0);
        // The other two components turn by twice the half angle, backwards.
        double& next = momentum_B[(axis + 1) % 3];
        double& last = momentum_B[(axis + 2) % 3];
        const double cosine = c * c - s * s;
        const double sine = 2.0 * s * c;
        const double turned = cosine * next + sine * last;
        last = cosine * last - sine * next;
        next = turned;
    };
    turn_about(order.least, 0.5 * dt_s);
    turn_about(order.most, dt_s);
    turn_about(order.least, 0.5 * dt_s);
    q.normalize();
    return q;
}

std::string_view to_string(Integrator integrator) noexcept {
    constexpr std::array<std::string_view, 5> kNames{"explicit Euler", "semi-implicit Euler",
                                                     "Verlet", "RK4", "backward Euler"};
    return kNames[static_cast<std::size_t>(integrator)];
}

StepResult step_rigid_body(const IntegratorSettings& settings, const Inertia& inertia,
                           const Load& load, double time_s, double dt_s,
                           RigidState& state) noexcept {
    RigidState next = state;
    const StepResult result = step_by_name(settings, {inertia, load, time_s, dt_s}, state, next);
    if (!result.moved()) {
        return result;
    }
    next.pose_W.orientation.normalize();
    if (!is_finite(next)) {
        return {StepStatus::not_finite, result.n_solves};
    }
    state = next;
    return result;
}

}  // namespace fulcrum
