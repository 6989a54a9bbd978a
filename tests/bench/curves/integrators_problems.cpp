// The problems on which integrators are compared.
#include "haptics/dynamics/loads.h"
#include "tests/bench/curves/integrators.h"
#include "tests/support/free_rotation.h"

#include <array>
#include <cmath>
#include <numbers>

namespace fulcrum::bench {
namespace {

// 0.1 kg on a spring of 100 N/m, lightly damped: 5 Hz, known in closed form.
constexpr double kMass_kg = 0.1;
constexpr double kStart_m = 0.01;
const PointSpring kSpring{.stiffness_N_per_m = 100.0, .damping_Ns_per_m = 0.316};
const PointSpringLoad kOscillatorLoad(kSpring);

double compute_exact_m(double time_s) {
    const double decay = kSpring.damping_Ns_per_m / (2.0 * kMass_kg);
    const double ringing = std::sqrt(kSpring.stiffness_N_per_m / kMass_kg - decay * decay);
    return kStart_m * std::exp(-decay * time_s) *
           (std::cos(ringing * time_s) + decay / ringing * std::sin(ringing * time_s));
}

// 100 g pressed on a plane of 2 kN/m at each of three points, off its rest: a stiff contact that is not left.
PlaneContact make_foot(double x_m, double z_m) {
    return {.point_B = {x_m, -0.01, z_m},
            .plane_point_W = Vector3::Zero(),
            .normal_W = Vector3::UnitY(),
            .stiffness_N_per_m = 2000.0,
            .damping_Ns_per_m = 3.0,
            .damping_ramp_m = 0.0};
}

const std::array<PlaneContact, 3> kFeet{make_foot(0.03, 0.0), make_foot(-0.02, 0.025),
                                        make_foot(-0.02, -0.025)};
const PlaneContactsLoad kContacts(kFeet);
const ConstantLoad kPress({.force = {0.0, -3.0, 0.0}});
const Loads kContactLoad(kContacts, kPress);

double compute_feet_N(const RigidState& state) {
    double sum_N = 0.0;
    for (const PlaneContact& foot : kFeet) {
        sum_N += compute_push_N(foot, state);
    }
    return sum_N;
}

const Loads<> kNoLoad;

// A tool of 50 g on its six-degree-of-freedom coupling, caught up by a handle that moves and turns.
constexpr double kReach_m = 0.03;  // from the centre to the tip, where a turn is seen
const Inertia kTool = make_box_inertia(0.05, {0.03, 0.04, 0.05});

ToolCouplingLoad make_load() {
    ToolCouplingLoad load(make_critically_damped({}, kTool.mass_kg, kTool.moments_kg_m2),
                          {0.0, 0.01, -0.02});
    load.set_handle({Pose::at(Vector3::Zero()), {{0.1, 0.0, 0.05}, {0.0, 1.0, 2.0}}}, 0.0);
    return load;
}
const ToolCouplingLoad kToolLoad = make_load();

}  // namespace

IntegratorProblem make_oscillator_problem() {
    IntegratorProblem problem{
        "integrators-oscillator",
        "Integrators on an oscillator",
        "0.1 kg on 100 N/m with a damping ratio of 0.05 (5 Hz), let go at 10 mm, for 1 s; the "
        "worst error of position at any of 50 instants",
        "analytic: the damped oscillation in closed form",
        "For soft springs RK4 is the bargain at any rate; Verlet is somewhat cheaper and keeps the "
        "energy of what must swing for hours. Backward Euler, the default of the library's step, "
        "damps the swing by itself: it is there for what is stiff.",
        {"error of position", "mm", true},
        make_ball_inertia(kMass_kg, 0.03)};
    problem.start.pose_W.position.x() = kStart_m;
    problem.load = &kOscillatorLoad;
    for (int i = 1; i <= 50; ++i) {
        RigidState state;
        state.pose_W.position.x() = compute_exact_m(i * kSample_s);
        problem.course.push_back(state);
    }
    problem.compute_error = [](const RigidState& state, const RigidState& expected) {
        return 1.0e3 * (state.pose_W.position - expected.pose_W.position).norm();
    };
    problem.unstable_above = 2.0e3 * kStart_m;
    problem.rounding = 1.0e-10;
    return problem;
}

IntegratorProblem make_contact_problem() {
    IntegratorProblem problem{
        "integrators-contact",
        "Integrators on a stiff contact",
        "100 g pressed by 3 N on a plane, 2 kN/m and 3 Ns/m at each of three points, let go 0.3 mm "
        "too deep, for 0.4 s; the worst error of the contact force at any of 20 instants",
        {},
        "On stiff contacts explicit methods end where h sqrt(k/m) passes about 2, explicit Euler "
        "already where h passes b/k; below that RK4 is the most exact. Backward Euler goes on at "
        "any rate, so it is the default of the library's step.",
        {"error of contact force", "N", true},
        make_box_inertia(0.1, {0.05, 0.02, 0.05})};
    problem.start.pose_W.position = {0.0, 0.0092, 0.0};
    problem.load = &kContactLoad;
    problem.compute_error = [](const RigidState& state, const RigidState& expected) {
        return std::abs(compute_feet_N(state) - compute_feet_N(expected));
    };
    problem.unstable_above = 6.0;  // twice the pressing force
    problem.rounding = 1.0e-9;
    take_converged_course(problem, 20);
    return problem;
}

// A body that turns freely, started almost about its middle axis: it tumbles over, and back.
IntegratorProblem make_free_rotation_problem() {
    IntegratorProblem problem{
        "integrators-rotation",
        "Integrators on a free rotation",
        "a body with moments 2 : 3 : 4 spun at 10 rad/s about its middle axis, all but a little, "
        "for 3 s: one somersault; the worst error of its orientation at any of 150 instants",
        "analytic: Jacobi's elliptic functions, and one quadrature for the precession",
        "For seconds RK4 is the most exact; what spins for hours wants Verlet, whose drift is a "
        "splitting of the free rotation itself and keeps angular momentum and energy. Euler "
        "methods change the tumbling within a turn, and backward Euler ends it.",
        {"error of orientation", "degrees", true},
        {0.1, {2.0e-5, 3.0e-5, 4.0e-5}}};
    problem.load = &kNoLoad;
    test::FreeRotation exact(problem.inertia.moments_kg_m2, 10.0, 0.999);
    problem.start = exact.compute_state(0.0);
    for (int i = 1; i <= 150; ++i) {
        problem.course.push_back(exact.compute_state(i * kSample_s));
    }
    problem.compute_error = [](const RigidState& state, const RigidState& expected) {
        return test::compute_angle_rad(state.pose_W.orientation, expected.pose_W.orientation) *
               180.0 / std::numbers::pi;
    };
    problem.unstable_above = 180.0;
    problem.rounding = 2.0e-8;
    return problem;
}

IntegratorProblem make_tool_problem() {
    IntegratorProblem problem{
        "integrators-tool",
        "Integrators on a tool on its coupling",
        "a tool of 50 g on 500 N/m and 0.5 Nm/rad, critically damped, 15 mm and 0.9 rad behind a "
        "handle that moves at 0.11 m/s and turns at 2.2 rad/s, for 0.2 s; the worst error of its "
        "tip, 30 mm from the centre, at any of 10 instants",
        {},
        "At 1 kHz and above all methods follow a coupling of 500 N/m at 50 g, RK4 best; backward "
        "Euler is the one that stays stable when the tool is light, the coupling stiff or the rate "
        "low.",
        {"error of the tip", "mm", true},
        kTool};
    problem.start.pose_W.position = {0.012, -0.007, 0.004};
    problem.start.pose_W.orientation = compute_exp({0.4, -0.7, 0.3});
    problem.load = &kToolLoad;
    problem.compute_error = [](const RigidState& state, const RigidState& expected) {
        const double turn_rad =
            test::compute_angle_rad(state.pose_W.orientation, expected.pose_W.orientation);
        const double shift_m = (state.pose_W.position - expected.pose_W.position).norm();
        return 1.0e3 * (shift_m + kReach_m * turn_rad);
    };
    problem.unstable_above = 30.0;  // twice the stretch at the start
    problem.rounding = 1.0e-9;
    take_converged_course(problem, 10);
    return problem;
}

}  // namespace fulcrum::bench
