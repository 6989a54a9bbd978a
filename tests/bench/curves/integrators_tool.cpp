// A tool of 50 g on its six-degree-of-freedom coupling, caught up by a handle that moves and turns.
#include "haptics/dynamics/loads.h"
#include "tests/bench/curves/integrators.h"
#include "tests/support/free_rotation.h"

namespace fulcrum::bench {
namespace {

constexpr double kReach_m = 0.03;  // from the centre to the tip, where a turn is seen
const Inertia kTool = make_box_inertia(0.05, {0.03, 0.04, 0.05});

ToolCouplingLoad make_load() {
    ToolCouplingLoad load(make_critically_damped({}, kTool.mass_kg, kTool.moments_kg_m2),
                          {0.0, 0.01, -0.02});
    load.set_handle({Pose::at(Vector3::Zero()), {{0.1, 0.0, 0.05}, {0.0, 1.0, 2.0}}}, 0.0);
    return load;
}
const ToolCouplingLoad kLoad = make_load();

}  // namespace

IntegratorProblem make_tool_problem() {
    IntegratorProblem problem;
    problem.name = "integrators-tool";
    problem.title = "Integrators on a tool on its coupling";
    problem.work =
        "a tool of 50 g on 500 N/m and 0.5 Nm/rad, critically damped, 15 mm and 0.9 rad behind a "
        "handle "
        "that moves at 0.11 m/s and turns at 2.2 rad/s, for 0.2 s; the worst error of its tip, 30 "
        "mm from "
        "the centre, at any of 10 instants";
    problem.advice =
        "At 1 kHz and above all methods follow a coupling of 500 N/m at 50 g, RK4 best; backward "
        "Euler is the one that stays stable when the tool is light, the coupling stiff or the rate "
        "low.";
    problem.error = {"error of the tip", "mm", true};
    problem.inertia = kTool;
    problem.start.pose_W.position = {0.012, -0.007, 0.004};
    problem.start.pose_W.orientation = compute_exp({0.4, -0.7, 0.3});
    problem.load = &kLoad;
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
