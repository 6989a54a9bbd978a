// 0.1 kg on a spring of 100 N/m, lightly damped: 5 Hz, known in closed form.
#include "haptics/dynamics/loads.h"
#include "tests/bench/curves/integrators.h"

#include <cmath>

namespace fulcrum::bench {
namespace {

constexpr double kMass_kg = 0.1;
constexpr double kStart_m = 0.01;
const PointSpring kSpring{.stiffness_N_per_m = 100.0, .damping_Ns_per_m = 0.316};
const PointSpringLoad kLoad(kSpring);

double compute_exact_m(double time_s) {
    const double decay = kSpring.damping_Ns_per_m / (2.0 * kMass_kg);
    const double ringing = std::sqrt(kSpring.stiffness_N_per_m / kMass_kg - decay * decay);
    return kStart_m * std::exp(-decay * time_s) *
           (std::cos(ringing * time_s) + decay / ringing * std::sin(ringing * time_s));
}

}  // namespace

IntegratorProblem make_oscillator_problem() {
    IntegratorProblem problem;
    problem.name = "integrators-oscillator";
    problem.title = "Integrators on an oscillator";
    problem.work =
        "0.1 kg on 100 N/m with a damping ratio of 0.05 (5 Hz), let go at 10 mm, for 1 s; the "
        "worst "
        "error of position at any of 50 instants";
    problem.reference = "analytic: the damped oscillation in closed form";
    problem.advice =
        "For soft springs RK4 is the bargain at any rate; Verlet is somewhat cheaper and keeps the "
        "energy of what must swing for hours. Backward Euler, the default of the library's step, "
        "damps the swing by itself: it is there for what is stiff.";
    problem.error = {"error of position", "mm", true};
    problem.inertia = make_ball_inertia(kMass_kg, 0.03);
    problem.start.pose_W.position.x() = kStart_m;
    problem.load = &kLoad;
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

}  // namespace fulcrum::bench
