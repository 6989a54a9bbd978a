// Otaduy & Lin 2005, figure 4, on a scene of planes: penetration, coupling deviation, contact and felt force over 600 ms
// for RK4 at 100 g and backward Euler at 10 g; and the least mass that each integrator can move there.
#include "tests/bench/curves/l14_charts.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/spoon_scene.h"

namespace fulcrum::bench {
namespace {

using test::SpoonSample;
using test::SpoonSettings;

struct Variant {
    const char* name;
    SpoonSettings settings;
};
const std::array<Variant, 4> kVariants{
    {{"RK4, 100 g, 2 kN/m", {.integrator = Integrator::runge_kutta_4, .mass_kg = 0.1}},
     {"backward Euler, 10 g, 2 kN/m", {.mass_kg = 0.01}},
     {"backward Euler, 10 g, 10 kN/m", {.mass_kg = 0.01, .contact_stiffness_N_per_m = 1.0e4}},
     {"RK4, 10 g, 2 kN/m: chatters", {.integrator = Integrator::runge_kutta_4, .mass_kg = 0.01}}}};

using Quantity = CourseQuantity<SpoonSample>;
const std::array<Quantity, 4> kQuantities{
    {{"l14-penetration",
      "Penetration",
      {"penetration depth", "mm"},
      [](const SpoonSample& s) { return 1.0e3 * s.penetration_m; },
      "Backward Euler lets contacts be five times stiffer, and the spoon sinks in a fifth as "
      "deep."},
     {"l14-coupling-deviation",
      "Coupling deviation",
      {"coupling deviation", "mm"},
      [](const SpoonSample& s) { return 1.0e3 * s.coupling_deviation_m; },
      "In free motion, up to 120 ms, a spoon of 100 g lags nine times as far behind the hand as "
      "one of 10 g."},
     {"l14-contact-force",
      "Contact force",
      {"contact force", "N"},
      [](const SpoonSample& s) { return s.contact_force_N; },
      "The light spoon strikes softer and settles at once; that of 100 g strikes beyond the "
      "paper's axis."},
     {"l14-felt-force",
      "Feedback force",
      {"feedback force", "N"},
      [](const SpoonSample& s) { return s.felt_force_N; },
      "What is felt before 120 ms is the spoon's inertia and nothing else: take the lightest one "
      "that is stable."}}};

LineChart make_chart(const Quantity& quantity,
                     const std::vector<std::vector<SpoonSample>>& courses) {
    LineChart chart = make_course_chart(quantity, kVariants, courses);
    chart.title = std::string(quantity.title) + " of a spoon in a cup's handle";
    chart.work =
        "a spoon on a coupling of 500 N/m at 1 kHz, its stem through a ring, pressed against it "
        "from 120 ms on, held still from 300 ms, drawn along from 450 ms; contact damping 8 Ns/m "
        "for every mass";
    chart.reference =
        "after Otaduy & Lin 2005, figure 4, whose axes end at 0.7 mm, 5 mm and 1.8 N; their scene "
        "is of meshes, this one of planes";
    return chart;
}

constexpr double kHeaviest_kg = 0.1;
constexpr double kLightest_kg = 0.001;

// The least mass down to which every one tried is still while the hand is; kNone when the heaviest is not.
double find_least_mass_kg(Integrator integrator, double stiffness_N_per_m, double factor) {
    double least_kg = kNone;
    for (double mass_kg = kHeaviest_kg; mass_kg > 0.999 * kLightest_kg; mass_kg *= factor) {
        if (!test::comes_to_rest(
                test::run_spoon({.integrator = integrator,
                                 .mass_kg = mass_kg,
                                 .contact_stiffness_N_per_m = stiffness_N_per_m}))) {
            break;
        }
        least_kg = mass_kg;
    }
    return least_kg;
}

Sheet make_sheet(const Run& run) {
    Sheet sheet{
        "l14-least-mass",
        "The lightest spoon that stays stable",
        "the same course, with masses from 100 g down to 1 g: the least down to which all come to "
        "rest while the hand is still",
        "Otaduy & Lin had to take 100 g for RK4; on these planes, whose contacts are found anew at "
        "every stage, RK4 needs less than that and far more than backward Euler. The coupling is "
        "critically damped about each axis: with one damper for the mean moment, 86 times the "
        "least, no explicit method comes to rest even at 100 g.",
        {"integrator", "at 2 kN/m, g", "at 10 kN/m, g"}};
    int n_done = 0;
    for (const Integrator integrator : kIntegrators) {
        run.progress(0.2 + 0.16 * n_done++, "least mass, " + std::string(to_string(integrator)));
        std::vector<std::string> row{std::string(to_string(integrator))};
        for (const double stiffness_N_per_m : {2.0e3, 1.0e4}) {
            const double least_kg =
                find_least_mass_kg(integrator, stiffness_N_per_m, run.pick(0.93, 0.6));
            row.push_back(std::isfinite(least_kg) ? to_text(rounded(1.0e3 * least_kg, 1))
                                                  : "none up to 100");
        }
        sheet.rows.push_back(std::move(row));
    }
    return sheet;
}

Report run_l14(Run& run) {
    std::vector<std::vector<SpoonSample>> courses;
    courses.reserve(kVariants.size());
    for (const Variant& variant : kVariants) {
        courses.push_back(test::run_spoon(variant.settings));
    }
    Report report;
    for (const Quantity& quantity : kQuantities) {
        report.emplace_back(make_chart(quantity, courses));
    }
    report.emplace_back(make_sheet(run));
    return report;
}

const Registration kL14{
    {"l14", "a spoon in a cup's handle: RK4 and backward Euler, as Otaduy and Lin compared them",
     run_l14}};

}  // namespace
}  // namespace fulcrum::bench
