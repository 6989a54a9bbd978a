// What it costs to project an acceleration onto what contacts allow, against how many contacts there are: anew each time, and as a loop asks it,
// with a little else wanted in every step.
#include "haptics/constraint/least_constraint.h"

#include "tests/bench/curves/touching.h"
#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

Vector6 wanted_at(double phase) {
    Vector6 wanted;
    wanted << std::sin(phase), -3.0, std::cos(1.3 * phase), 20.0 * std::sin(0.7 * phase),
        5.0 * std::cos(phase), 20.0 * std::sin(1.1 * phase);
    return wanted;
}

Cost measure(int n, bool flat, bool anew, const Timing& timing) {
    const std::vector<Touching> contacts = make_touching(n, flat);
    LeastConstraintSolver solver(contacts.size());
    solver.set_inertia(0.05, Vector3(2.0e-5, 8.0e-5, 8.0e-5).asDiagonal());
    double phase = 0.0;
    return measure_cost(
        [&] {
            phase += anew ? 1.0 : 0.002;
            if (anew) {
                solver.clear();
                (void)solver.solve(wanted_at(phase));  // nothing acts, nothing is remembered
            }
            solver.clear();
            for (const Touching& c : contacts) {
                solver.add(c.arm_W, c.normal_W);
            }
            keep(solver.solve(wanted_at(phase)).force);
        },
        timing);
}

Report run_least_constraint(Run& run) {
    LineChart chart;
    chart.name = "least-constraint";
    chart.title = "Projecting onto what contacts allow";
    chart.work =
        "One rigid tool, contacts in one plane or from everywhere below; contacts are told and the "
        "acceleration is projected, anew, or from where the step before ended. Median of a step.";
    chart.advice =
        "Tell contacts in the same order from step to step; what matters is how many there are, "
        "not how many of them are redundant.";
    chart.x = {"contacts", "", true};
    chart.y = {"time", "us", true};
    const Timing timing{run.pick(4000, 200), 1, 100};
    for (const bool flat : {true, false}) {
        for (const bool anew : {true, false}) {
            chart.trace(
                std::string(flat ? "one plane" : "a hollow") + (anew ? ", anew" : ", step by step"),
                LineStyle::measured, {1, 3, 10, 30, 100, 300, 1000}, [&](double n) {
                    return measure(static_cast<int>(n), flat, anew, timing).median_us;
                });
        }
    }
    return {chart};
}

const Registration kLeastConstraint{
    {"least-constraint",
     "what projecting onto the constraints of a god-object costs by its contacts",
     run_least_constraint}};

}  // namespace
}  // namespace fulcrum::bench
