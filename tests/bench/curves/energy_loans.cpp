// What even normals on facets may give a hand that goes round on them for ever, and what the loan that allows it costs in force, over how
// long a debt is kept and how much is lent (haptics/surface/energy_loan.h). Plan, passivity stage and gate are those of a lesson.
#include "haptics/geometry/shape.h"
#include "haptics/surface/energy_loan.h"
#include "haptics/surface/materials.h"
#include "tests/bench/curves/felt_sphere.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/closed_path.h"
#include "tests/support/sent_force.h"
#include "tests/support/touchable.h"

namespace fulcrum::bench {
namespace {

constexpr double kRound_s = 0.1;
constexpr int kRounds = 200;  // until what is lent has been had
constexpr double kSpan_rad = 0.3;

Material make_plain(const CouplingSettings& coupling) {
    Material material = *find_material("metal");
    material.friction = {};
    material.texture = {};
    material.transient = {};
    material.coupling = coupling;
    return material;
}

std::function<void(HapticPlan&)> with_loan(const EnergyLoanSettings& loan) {
    return [loan](HapticPlan& plan) { plan.shading_loan = loan; };
}

// The most of several places that kRounds rounds give once as many are over, mJ a round: there deeper, back less deep.
double find_given_mJ(const EnergyLoanSettings& loan, int n_places) {
    const auto coarse = touchable(must(make_sphere(kStrokedBall_m, 2)));
    double most_J = 0.0;
    for (int i = 0; i < n_places; ++i) {
        test::SentForce loop(
            test::make_touch_lesson(
                make_plain({.stiffness_N_per_m = 200.0, .damping_Ns_per_m = 0.0}), true),
            coarse, with_loan(loan));
        const test::Path path =
            test::make_arc(kStrokedBall_m, 0.27 * i, kSpan_rad, i % 2 == 1 ? 0.008 : 0.022,
                           i % 2 == 1 ? 0.022 : 0.008);
        loop.open_gate(1.2 * path(0.0));
        for (double share = 1.2; share > 1.0; share -= 1.0e-4) {
            (void)loop.step(share * path(0.0));
        }
        most_J = std::max(most_J, test::go_round(loop, path, kRound_s, kRounds).last_J / kRounds);
    }
    return 1.0e3 * most_J;
}

// Along the surface of a ball of 320 facets, N.
double find_sideways_N(const EnergyLoanSettings& loan) {
    const Material metal = make_plain(find_material("metal")->coupling);
    test::SentForce loop(test::make_touch_lesson(metal, true),
                         touchable(must(make_sphere(kStrokedBall_m, 4))), with_loan(loan));
    loop.open_gate(Vector3(0.0, 1.2 * kStrokedBall_m, 0.0));
    return stroke_ball([&](const Vector3& hand_W) { return loop.step(hand_W); },
                       kStrokePush_N / metal.coupling.stiffness_N_per_m)
        .sideways_N;
}

Report run_energy_loans(Run& run) {
    LineChart given;
    given.name = "energy-loans";
    given.title = "What facets that are felt evenly give who goes round on them, over the memory";
    given.work =
        "A hand goes there deeper than back, ten times a second, on a ball of 10 cm and 80 "
        "facets, 200 N/m and undamped: rounds 201 to 400, the most of several places.";
    given.advice =
        "As it ships, 10 s and all that a facet's lean can do: nothing of the force is kept back. "
        "With 3 s facets give as if nobody counted; of what is left with more, 0.6 mJ a round are "
        "forgiven to the way.";
    given.x = {"memory of a debt", "s", true};
    given.y = {"given a round", "mJ", false};
    LineChart error = given;
    error.name = "energy-loans-force";
    error.title = "What a loan on facets costs in force, over the memory";
    error.work =
        "A hand strokes a ball of 10 cm and 320 facets at 0.2 m/s, pressed with 2 N: metal without "
        "friction; the second time round.";
    error.advice =
        "As it ships, all that a facet's lean can do: a tenth of it would be felt as facets, at "
        "any "
        "memory.";
    error.reference = "analytic: the true ball's normal";
    error.y = {"force along the surface, rms", "N", false};
    const auto memories_s =
        run.pick<std::vector<double>>({0.03, 0.1, 0.3, 1, 3, 10, 30, 100, 1000}, {0.1, 10});
    const int n_places = run.pick(8, 2);
    double done = 0.0;
    for (const double share : run.pick<std::vector<double>>({0.0, 0.1, 1.0, 10.0}, {1.0})) {
        run.progress(done, "share " + to_text(share));
        done += 0.25;
        const std::string name = to_text(share) + " of a facet's lean lent";
        given.trace(name, LineStyle::measured, memories_s, [&](double memory_s) {
            return find_given_mJ({memory_s, share}, n_places);
        });
        error.trace(name, LineStyle::measured, memories_s, [&](double memory_s) {
            return find_sideways_N({memory_s, share});
        });
    }
    return {given, error};
}

const Registration kEnergyLoans{
    {"energy-loans", "what even normals on facets may give a hand, and what that costs in force",
     run_energy_loans}};

}  // namespace
}  // namespace fulcrum::bench
