// What the force of a god-object's contacts costs: as its loop asks for it, from contacts that are told, and where they are told anew as after each
// step of the tool; without and with friction.
#include "haptics/math/rotation.h"
#include "haptics/tool/god_force.h"
#include "tests/bench/curves/touching.h"
#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

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

}  // namespace
}  // namespace fulcrum::bench
