// What the force of a god-object's contacts costs: as its loop asks for it, from contacts that are told, and where they are told anew as after each
// step of the tool; without and with friction.
#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"
#include "haptics/tool/god_force.h"
#include "tests/bench/harness/csv.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/registry.h"

#include <cmath>
#include <string>
#include <vector>

namespace fulcrum::bench {
namespace {

constexpr double kFriction = 0.5;

struct Touching {
    Vector3 arm_W, normal_W;
};

// In one plane, as a tool lies flat; or from everywhere below, as it is stuck in a hollow.
std::vector<Touching> make_touching(int n, bool flat) {
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

std::string to_us(double us) {
    return to_text(std::round(100.0 * us) / 100.0);
}

Report run_constraint_force(Run& run) {
    Sheet sheet;
    sheet.name = "constraint-force";
    sheet.title = "The force of a god-object's contacts";
    sheet.work =
        "One rigid tool, its contacts in one plane or from everywhere below, the handle a little "
        "elsewhere each time. Asked: by the force's own loop, between two steps of the tool. Told: "
        "contacts told anew and asked, as behind each step. Friction: 0.5";
    sheet.advice =
        "Friction only where it is to be felt; the loop of the force without it may be as "
        "fast as the device is.";
    sheet.columns = {"contacts", "how they lie",    "friction",      "asked, median us",
                     "99 %, us", "told, median us", "told, 99 %, us"};
    const Timing timing{run.pick(4000, 200), 1, 100};
    for (const int n : run.pick<std::vector<int>>({3, 10, 30, 100}, {30})) {
        for (const bool flat : {true, false}) {
            for (const double friction : {0.0, kFriction}) {
                const Costs costs = measure_force(n, flat, friction, timing);
                sheet.rows.push_back({std::to_string(n), flat ? "one plane" : "a hollow",
                                      friction > 0.0 ? "with" : "without",
                                      to_us(costs.asked.median_us), to_us(costs.asked.p99_us),
                                      to_us(costs.told.median_us), to_us(costs.told.p99_us)});
            }
        }
    }
    return {sheet};
}

const Registration kConstraintForce{
    {"constraint-force", "what the force of a god-object's contacts costs", run_constraint_force}};

}  // namespace
}  // namespace fulcrum::bench
