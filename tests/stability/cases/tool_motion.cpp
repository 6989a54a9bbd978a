// A rigid tool by itself: an hour of free rotation, a stiff coupling in free space, and a tool let go at full stretch.
#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/loads.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/free_rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace fulcrum::stability {
namespace {

const Inertia kBlock{0.1, {2.0e-5, 3.0e-5, 4.0e-5}};
constexpr double kDt_s = 0.001;
constexpr int kHour_steps = 3'600'000;

IntegratorSettings settings_of(Integrator integrator) {
    IntegratorSettings settings;
    settings.integrator = integrator;
    return settings;
}

// How far energy and angular momentum go during an hour of somersaults at 10 rad/s.
struct Drift {
    double energy_up = 0.0;     // worst relative gain
    double energy_down = 0.0;   // worst relative loss
    double momentum = 0.0;      // worst relative change
    double least_energy = 0.0;  // the least that this momentum allows, relative
};

Drift spin_for_an_hour(Integrator integrator) {
    test::FreeRotation exact(kBlock.moments_kg_m2, 10.0, 0.999);
    RigidState state = exact.compute_state(0.0);
    const Vector3 momentum = compute_angular_momentum_W(kBlock, state);
    const double energy_J = compute_kinetic_energy_J(kBlock, state);
    Drift drift;
    drift.least_energy =
        momentum.squaredNorm() / (2.0 * kBlock.moments_kg_m2.maxCoeff() * energy_J);
    const Loads<> nothing;
    for (int i = 0; i < kHour_steps; ++i) {
        if (!step_rigid_body(settings_of(integrator), kBlock, nothing, i * kDt_s, kDt_s, state)
                 .moved()) {
            return {HUGE_VAL, HUGE_VAL, HUGE_VAL, 0.0};
        }
        if (i % 100 == 0) {
            const double now = compute_kinetic_energy_J(kBlock, state) / energy_J;
            drift.energy_up = worse(drift.energy_up, now - 1.0);
            drift.energy_down = worse(drift.energy_down, 1.0 - now);
            drift.momentum = worse(
                drift.momentum,
                (compute_angular_momentum_W(kBlock, state) - momentum).norm() / momentum.norm());
        }
    }
    return drift;
}

std::string percent(double share) {
    return describe("%.3g %%", 100.0 * share);
}

// A symplectic step keeps a nearby energy, which differs by the square of the step: the bound is (h w)^2 / 10 = 1e-5, for
// an hour as for a second.
Finding spin_with_verlet() {
    const Drift drift = spin_for_an_hour(Integrator::verlet);
    return {worse(worse(drift.energy_up, drift.energy_down), drift.momentum), 1.0e-5,
            "momentum " + percent(drift.momentum)};
}

// Backward Euler, the default, dissipates: it may only lose energy, and not more than the angular momentum allows; the
// momentum itself is kept up to Newton's tolerance, 1e-7 rad/s of 10 rad/s a step, which seldom is all used.
Finding spin_with_default() {
    const Drift drift = spin_for_an_hour(IntegratorSettings{}.integrator);
    const double below = drift.energy_down - (1.0 - drift.least_energy);
    return {worse(worse(drift.energy_up, below), drift.momentum), 1.0e-4,
            "energy lost " + percent(drift.energy_down) + " of at most " +
                percent(1.0 - drift.least_energy)};
}

const std::array<double, 7> kSteps_s{0.00025, 0.0005, 0.001, 0.002, 0.004, 0.01, 0.02};

// A tool of 10 g on 50 kN/m behind a hand at 0.5 m/s and 3 rad/s: once it follows, the hand feels nothing.
Finding drag_in_free_space() {
    ToolCouplingSettings stiff;
    stiff.shift.stiffness_N_per_m = 5.0e4;
    stiff.turn.stiffness_Nm_per_rad = 50.0;
    const Inertia tool{0.01, Vector3::Constant(2.4e-6)};
    stiff = make_critically_damped(stiff, tool.mass_kg, tool.moments_kg_m2);
    const Twist even{{0.5, 0.0, 0.0}, {0.0, 3.0, 0.0}};
    double worst_N = 0.0;
    for (const double dt_s : kSteps_s) {
        ToolCouplingLoad coupling(stiff);
        coupling.set_handle({Pose::at(Vector3::Zero()), even}, 0.0);
        RigidState state;
        const int n_steps = static_cast<int>(std::lround(2.0 / dt_s));
        for (int i = 1; i <= n_steps; ++i) {
            const double now_s = i * dt_s;
            if (!step_rigid_body({}, tool, coupling, now_s - dt_s, dt_s, state).moved()) {
                return {HUGE_VAL, 1.0e-3, "a step was refused"};
            }
            if (now_s > 0.5) {
                worst_N = worse(worst_N, coupling.compute_felt_wrench(state, now_s).force.norm());
            }
        }
    }
    return {worst_N, 1.0e-3, "0.25 to 20 ms a step"};
}

// The integral of a coupling's curve from 0 to `stretch`. It is a cubic on each piece, so Simpson's rule is exact there.
template <class Curve>
double integrate_curve(double linear, double saturation, double stretch, Curve curve) {
    double sum = 0.0;
    double from = 0.0;
    for (const double end : {linear, saturation, HUGE_VAL}) {
        const double to = std::min(end, stretch);
        if (to > from) {
            sum += (to - from) / 6.0 * (curve(from) + 4.0 * curve(0.5 * (from + to)) + curve(to));
            from = to;
        }
    }
    return sum;
}

// The work that the springs can do.
double compute_spring_energy_J(const ToolCouplingSettings& settings, double stretch_m,
                               double turn_rad) {
    const MovingFrame grip;
    const auto force = [&](double s) {
        return compute_tool_coupling(settings, {Pose::at({s, 0.0, 0.0}), {}}, grip).force.x();
    };
    const auto torque = [&](double angle) {
        const MovingFrame hand{{Vector3::Zero(), compute_exp({angle, 0.0, 0.0})}, {}};
        return compute_tool_coupling(settings, hand, grip).torque.x();
    };
    return integrate_curve(settings.shift.linear_range_m, settings.shift.saturation_range_m,
                           stretch_m, force) +
           integrate_curve(settings.turn.linear_range_rad, settings.turn.saturation_range_rad,
                           turn_rad, torque);
}

// Let go 10 cm and 3 rad away from the hand: 10 g must come to rest at the hand, and never have more energy than the
// springs held.
Finding let_go_at_full_stretch() {
    ToolCouplingSettings settings;
    settings.shift.linear_range_m = 0.006;
    settings.shift.saturation_range_m = 0.02;
    settings.shift.saturation_force_N = 6.0;
    settings.turn.linear_range_rad = 0.3;
    settings.turn.saturation_range_rad = 1.0;
    settings.turn.saturation_torque_Nm = 0.3;
    const Inertia tool{0.01, {1.8e-6, 2.4e-6, 3.0e-6}};
    const double held_J = compute_spring_energy_J(settings, 0.1, 3.0);
    double worst = 0.0;
    for (const double dt_s : kSteps_s) {
        ToolCouplingLoad coupling(settings);
        RigidState state;
        state.pose_W.position = {0.06, 0.08, 0.0};
        state.pose_W.orientation = compute_exp({1.0, 2.0, 2.0});
        const int n_steps = static_cast<int>(std::lround(3.0 / dt_s));
        for (int i = 0; i < n_steps; ++i) {
            if (!step_rigid_body({}, tool, coupling, i * dt_s, dt_s, state).moved()) {
                return {HUGE_VAL, 0.0, "a step was refused"};
            }
            const double now_J =
                compute_kinetic_energy_J(tool, state) +
                compute_spring_energy_J(settings, state.pose_W.position.norm(),
                                        compute_log(state.pose_W.orientation).norm());
            worst = worse(worst, now_J / held_J - 1.0);
        }
        // At rest at the hand, or it has not come back.
        const double away_m =
            state.pose_W.position.norm() + 0.03 * compute_log(state.pose_W.orientation).norm();
        worst = worse(worst, away_m <= 1.0e-6 ? 0.0 : away_m);
    }
    return {worst, 1.0e-6, "0.25 to 20 ms a step"};
}

const HardCase kHourVerlet{{"an hour of free rotation, Verlet",
                            "a block tumbles about its middle axis for 3.6 million steps",
                            "relative change of energy or angular momentum", "", spin_with_verlet}};
const HardCase kHourDefault{
    {"an hour of free rotation, backward Euler",
     "the same with the default integrator, which dissipates",
     "relative gain of energy, loss beyond the least, or change of momentum", "",
     spin_with_default}};
const HardCase kDrag{{"a stiff coupling in free space",
                      "10 g on 50 kN/m behind a hand that moves evenly", "force felt", "N",
                      drag_in_free_space}};
const HardCase kLetGo{
    {"a tool let go at full stretch", "10 g flung back by a coupling stretched by 10 cm and 3 rad",
     "relative gain of energy, or metres from rest after 3 s", "", let_go_at_full_stretch}};

}  // namespace
}  // namespace fulcrum::stability
