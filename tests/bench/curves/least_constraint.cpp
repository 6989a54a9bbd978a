#include "haptics/constraint/least_constraint.h"

#include "haptics/math/rotation.h"
#include "haptics/math/spatial.h"
#include "haptics/math/split_mix.h"
#include "haptics/tool/god_object/god_force.h"
#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

// Contacts of a tool: in one plane, as it lies flat; or from everywhere below, as it is stuck in a hollow.

struct Touching {
    Vector3 arm_W, normal_W;
};

[[nodiscard]] inline std::vector<Touching> make_touching(int n, bool flat) {
    SplitMix chance(static_cast<std::uint64_t>(n));
    const auto draw = [&] { return 2.0 * chance.draw_chance() - 1.0; };
    std::vector<Touching> touching;
    for (int k = 0; k < n; ++k) {
        const Vector3 arm(0.05 * draw(), -0.02, 0.05 * draw());
        const Vector3 normal =
            flat ? Vector3::UnitY() : Vector3(0.8 * draw(), 1.0, 0.8 * draw()).normalized();
        touching.push_back({arm, normal});
    }
    return touching;
}

// What the force of a god-object's contacts costs: as its loop asks for it, from contacts that are told, and where they are told anew as after each
// step of the tool; without and with friction.

constexpr double kFriction = 0.5;

// Pressed some millimetres deep, and moved a little from one question to the next.
Pose find_handle(double phase) {
    return {
        0.004 * Vector3(0.3 * std::sin(phase), -1.0, 0.3 * std::cos(1.3 * phase)),
        compute_exp(0.05 * Vector3(std::sin(0.7 * phase), std::cos(phase), std::sin(1.1 * phase)))};
}

struct Costs {
    Cost asked, told;
};

Costs measure_force(int n, bool flat, double friction, const Timing& timing) {
    const std::vector<Touching> touching = make_touching(n, flat);
    GodForce force(
        {.inertia = make_box_inertia(0.05, {0.1, 0.04, 0.1}), .has_friction = friction > 0.0},
        touching.size());
    const auto tell = [&] {
        force.begin(Pose{});
        for (const Touching& one : touching) {
            force.add(one.arm_W, one.normal_W, 0.0, friction);
        }
    };
    tell();
    double phase = 0.0;
    Costs costs;
    costs.asked =
        measure_cost([&] { keep(force.compute(find_handle(phase += 0.002)).force); }, timing);
    costs.told = measure_cost(
        [&] {
            tell();
            keep(force.compute(find_handle(phase += 0.002)).force);
        },
        timing);
    return costs;
}

Report run_constraint_force(Run& run) {
    Sheet sheet{
        "constraint-force",
        "The force of a god-object's contacts",
        "One rigid tool, its contacts in one plane or from everywhere below, the handle a little "
        "elsewhere each time. Asked: by the force's own loop, between two steps of the tool. Told: "
        "contacts told anew and asked, as behind each step. Friction: 0.5",
        "Friction only where it is to be felt; the loop of the force without it may be as fast as "
        "the device is.",
        {"contacts", "how they lie", "friction", "asked, median us", "99 %, us", "told, median us",
         "told, 99 %, us"}};
    const Timing timing{run.pick(4000, 200), 1, 100};
    for (const int n : run.pick<std::vector<int>>({3, 10, 30, 100}, {30})) {
        for (const bool flat : {true, false}) {
            for (const double friction : {0.0, kFriction}) {
                const Costs costs = measure_force(n, flat, friction, timing);
                sheet.add({n, flat ? "one plane" : "a hollow", friction > 0.0 ? "with" : "without",
                           rounded(costs.asked.median_us, 2), rounded(costs.asked.p99_us, 2),
                           rounded(costs.told.median_us, 2), rounded(costs.told.p99_us, 2)});
            }
        }
    }
    return {sheet};
}

const Registration kConstraintForce{
    {"constraint-force", "what the force of a god-object's contacts costs", run_constraint_force}};

// What it costs to project an acceleration onto what contacts allow, against how many contacts there are: anew each time, and as a loop asks it,
// with a little else wanted in every step.

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
