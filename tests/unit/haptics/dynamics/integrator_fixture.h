// Problems whose course is known, and how wrong an integrator is on them.
#pragma once

#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/loads.h"
#include "tests/support/free_rotation.h"

#include <cmath>
#include <functional>

namespace fulcrum::test {

inline const Inertia kBlock{0.1, {2.0e-5, 3.0e-5, 4.0e-5}};

inline IntegratorSettings settings_of(Integrator integrator) {
    IntegratorSettings settings;
    settings.integrator = integrator;
    // Below what the finest step of a test of convergence is wrong by.
    settings.newton_tolerance_m_per_s = 1.0e-12;
    settings.newton_tolerance_rad_per_s = 1.0e-12;
    return settings;
}

/// What theory promises where loads are smooth.
inline double theoretical_order(Integrator integrator) {
    switch (integrator) {
        case Integrator::verlet:
            return 2.0;
        case Integrator::runge_kutta_4:
            return 4.0;
        default:
            return 1.0;
    }
}

/// The state after n steps.
inline RigidState run(const IntegratorSettings& settings, const Inertia& inertia, const Load& load,
                      RigidState state, double duration_s, int n) {
    const double dt_s = duration_s / n;
    for (int i = 0; i < n; ++i) {
        step_rigid_body(settings, inertia, load, i * dt_s, dt_s, state);
    }
    return state;
}

/// Metres that a point of the body at `reach_m` from its centre may be off: shift, and turn times reach.
inline double distance_m(const RigidState& a, const RigidState& b, double reach_m) {
    return (a.pose_W.position - b.pose_W.position).norm() +
           reach_m * compute_angle_rad(a.pose_W.orientation, b.pose_W.orientation);
}

/// log2 of how much better twice as many steps are.
inline double measure_order(const std::function<double(int)>& error_of, int n) {
    return std::log2(error_of(n) / error_of(2 * n));
}

/// A pose and velocities off every axis.
inline RigidState any_state() {
    RigidState state;
    state.pose_W.position = {0.012, -0.007, 0.004};
    state.pose_W.orientation = compute_exp({0.4, -0.7, 0.3});
    state.velocity_W.linear = {0.05, 0.2, -0.1};
    state.velocity_W.angular = {3.0, -2.0, 5.0};
    return state;
}

}  // namespace fulcrum::test
