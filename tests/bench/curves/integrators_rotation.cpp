// A body that turns freely, started almost about its middle axis: it tumbles over, and back.
#include "tests/bench/curves/integrators.h"
#include "tests/support/free_rotation.h"

#include <numbers>

namespace fulcrum::bench {
namespace {

const Loads<> kNoLoad;

}  // namespace

IntegratorProblem make_free_rotation_problem() {
    IntegratorProblem problem;
    problem.name = "integrators-rotation";
    problem.title = "Integrators on a free rotation";
    problem.work =
        "a body with moments 2 : 3 : 4 spun at 10 rad/s about its middle axis, all but a little, "
        "for "
        "3 s: one somersault; the worst error of its orientation at any of 150 instants";
    problem.reference =
        "analytic: Jacobi's elliptic functions, and one quadrature for the precession";
    problem.advice =
        "For seconds RK4 is the most exact; what spins for hours wants Verlet, whose drift is a "
        "splitting of the free rotation itself and keeps angular momentum and energy. Euler "
        "methods change the tumbling within a turn, and backward Euler ends it.";
    problem.error = {"error of orientation", "degrees", true};
    problem.inertia = {0.1, {2.0e-5, 3.0e-5, 4.0e-5}};
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

}  // namespace fulcrum::bench
