// The four stages of integrator.h's runge_kutta_4.
#include "haptics/dynamics/integrator.h"

namespace fulcrum {
namespace {

// The derivative of (x, s, P, L) by time, or a step of it.
struct Slope {
    Vector3 position{Vector3::Zero()};
    Vector3 turn{Vector3::Zero()};  // s: q = exp(s) q_0
    Vector3 momentum{Vector3::Zero()};
    Vector3 angular_momentum{Vector3::Zero()};
};

struct Stages {
    const Inertia& inertia;
    const Load& load;
    const RigidState& start;
    Vector3 start_angular_momentum;

    // The body after `dt_s` along `slope`.
    [[nodiscard]] RigidState compute_state(const Slope& slope, double dt_s) const noexcept {
        RigidState state;
        state.pose_W.position = start.pose_W.position + dt_s * slope.position;
        state.pose_W.orientation = compute_exp(dt_s * slope.turn) * start.pose_W.orientation;
        state.velocity_W.linear = start.velocity_W.linear + dt_s / inertia.mass_kg * slope.momentum;
        state.velocity_W.angular =
            compute_spin_W(inertia, state.pose_W.orientation,
                           start_angular_momentum + dt_s * slope.angular_momentum);
        return state;
    }

    // The slope where `dt_s` along `slope` leads.
    [[nodiscard]] Slope compute_slope(const Slope& slope, double dt_s,
                                      double time_s) const noexcept {
        const RigidState state = compute_state(slope, dt_s);
        Wrench wrench;
        load.add_wrench(state, time_s, wrench);
        // s' = J_l(s)^-1 w, cut off behind the second bracket: the next term is of fourth order in s.
        const Vector3 s = dt_s * slope.turn;
        const Vector3& w = state.velocity_W.angular;
        const Vector3 bracket = s.cross(w);
        return {state.velocity_W.linear, w - 0.5 * bracket + s.cross(bracket) / 12.0, wrench.force,
                wrench.torque};
    }
};

}  // namespace

void step_runge_kutta_4(const Inertia& inertia, const Load& load, double time_s, double dt_s,
                        const RigidState& state, RigidState& next) noexcept {
    const Stages stages{inertia, load, state, compute_angular_momentum_W(inertia, state)};
    const double half_s = 0.5 * dt_s;
    const Slope k1 = stages.compute_slope({}, 0.0, time_s);
    const Slope k2 = stages.compute_slope(k1, half_s, time_s + half_s);
    const Slope k3 = stages.compute_slope(k2, half_s, time_s + half_s);
    const Slope k4 = stages.compute_slope(k3, dt_s, time_s + dt_s);
    const auto mean = [&](auto member) {
        return Vector3((k1.*member + 2.0 * (k2.*member + k3.*member) + k4.*member) / 6.0);
    };
    next = stages.compute_state({mean(&Slope::position), mean(&Slope::turn), mean(&Slope::momentum),
                                 mean(&Slope::angular_momentum)},
                                dt_s);
}

}  // namespace fulcrum
