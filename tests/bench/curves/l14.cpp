#include "tests/bench/harness/curve.h"
#include "tests/bench/harness/report.h"
#include "tests/support/jaws.h"
#include "tests/support/spoon_scene.h"

#include <cstddef>

namespace fulcrum::bench {
namespace {

// The charts of Otaduy & Lin 2005, figures 4 and 6: a quantity over the milliseconds of a course, a line a variant.

/// What is drawn of a sample.
template <class Sample>
struct CourseQuantity {
    const char* name;
    const char* title;
    Axis y;
    double (*value)(const Sample&);
    const char* advice;
};

/// The chart of one quantity; a variant has a `name` and a course.
template <class Sample, class Variants>
[[nodiscard]] LineChart make_course_chart(const CourseQuantity<Sample>& quantity,
                                          const Variants& variants,
                                          const std::vector<std::vector<Sample>>& courses) {
    LineChart chart;
    chart.name = quantity.name;
    chart.title = quantity.title;
    chart.advice = quantity.advice;
    chart.x = {"time", "ms"};
    chart.y = quantity.y;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        chart.draw(
            variants[i].name, courses[i], [](const Sample&) { return true; },
            [](const Sample& sample) { return 1.0e3 * sample.time_s; }, quantity.value);
    }
    return chart;
}

// Otaduy & Lin 2005, figure 4, on a scene of planes: penetration, coupling deviation, contact and felt force over 600 ms
// for RK4 at 100 g and backward Euler at 10 g; and the least mass that each integrator can move there.

using test::SpoonSample;
using test::SpoonSettings;

struct SpoonVariant {
    const char* name;
    SpoonSettings settings;
};
const std::array<SpoonVariant, 4> kSpoonVariants{
    {{"RK4, 100 g, 2 kN/m", {.integrator = Integrator::runge_kutta_4, .mass_kg = 0.1}},
     {"backward Euler, 10 g, 2 kN/m", {.mass_kg = 0.01}},
     {"backward Euler, 10 g, 10 kN/m", {.mass_kg = 0.01, .contact_stiffness_N_per_m = 1.0e4}},
     {"RK4, 10 g, 2 kN/m: chatters", {.integrator = Integrator::runge_kutta_4, .mass_kg = 0.01}}}};

using SpoonQuantity = CourseQuantity<SpoonSample>;
const std::array<SpoonQuantity, 4> kSpoonQuantities{
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

LineChart make_spoon_chart(const SpoonQuantity& quantity,
                           const std::vector<std::vector<SpoonSample>>& courses) {
    LineChart chart = make_course_chart(quantity, kSpoonVariants, courses);
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

Sheet make_mass_sheet(const Run& run) {
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
    courses.reserve(kSpoonVariants.size());
    for (const SpoonVariant& variant : kSpoonVariants) {
        courses.push_back(test::run_spoon(variant.settings));
    }
    Report report;
    for (const SpoonQuantity& quantity : kSpoonQuantities) {
        report.emplace_back(make_spoon_chart(quantity, courses));
    }
    report.emplace_back(make_mass_sheet(run));
    return report;
}

const Registration kL14{
    {"l14", "a spoon in a cup's handle: RK4 and backward Euler, as Otaduy and Lin compared them",
     run_l14}};

// Otaduy & Lin 2005, figure 6, on jaws of our own: penetration, the contact thread's rate, coupling deviation and felt force over 900 ms, with
// contact found each millisecond or 100 times a second, by planes, by their linearised model, and without a model.

using test::JawsSample;
using test::JawsSettings;

struct JawsVariant {
    const char* name;
    JawsSettings settings;
};
const std::array<JawsVariant, 5> kJawsVariants{
    {{"planes, each step", {}},
     {"linearised, each step", {.model = PenaltyModel::linearised}},
     {"planes, 100 Hz", {.round_s = 0.01}},
     {"linearised, 100 Hz", {.model = PenaltyModel::linearised, .round_s = 0.01}},
     {"no model, 500 Hz", {.model = PenaltyModel::held, .round_s = 0.002}}}};

using JawsQuantity = CourseQuantity<JawsSample>;
constexpr double kAxisEnd_N = 10.0;  // what diverges ends there
const std::array<JawsQuantity, 4> kJawsQuantities{
    {{"l14-jaws-penetration",
      "Penetration of two jaws",
      {"penetration depth", "mm"},
      [](const JawsSample& s) { return std::min(1.0e3 * s.penetration_m, 3.0); },
      "With contact found each step the jaws hardly meet within; 100 times a second they do, by "
      "what a hand goes in 10 ms, and stay stable."},
     {"l14-jaws-rate",
      "What the contact thread could do",
      {"rounds a second", "kHz"},
      [](const JawsSample& s) { return s.round_us > 0.0 ? 1.0e3 / s.round_us : kNone; },
      "Six thousand points in a field: the contact thread is never slower than the haptic one; the "
      "paper's fell to 0.1 kHz."},
     {"l14-jaws-deviation",
      "Coupling deviation of two jaws",
      {"coupling deviation", "mm"},
      [](const JawsSample& s) { return std::min(1.0e3 * s.deviation_m, 20.0); },
      "How far the hand presses; without a model of contact the tool is thrown about."},
     {"l14-jaws-felt-force",
      "Feedback force of two jaws",
      {"feedback force", "N"},
      [](const JawsSample& s) { return std::min(s.felt_N, kAxisEnd_N); },
      "Give the haptic loop planes instead of a force, and contact may be found as slowly as it "
      "must."}}};

LineChart make_jaws_chart(const JawsQuantity& quantity,
                          const std::vector<std::vector<JawsSample>>& courses) {
    LineChart chart = make_course_chart(quantity, kJawsVariants, courses);
    chart.work =
        "an upper jaw of 20 k triangles and 10 g on a coupling of 500 N/m bites into a lower one "
        "and grinds on it, contacts of 5 kN/m; lines end where they leave the axes";
    chart.reference =
        "after Otaduy & Lin 2005, figure 6, whose jaws have 40 k triangles and whose contact "
        "thread is slowed by a finer tolerance; here it is slowed by the clock";
    return chart;
}

Sheet make_jaws_sheet(const std::vector<std::vector<JawsSample>>& courses) {
    Sheet sheet{
        "l14-jaws",
        "Two jaws, with and without a model of contact",
        "the worst of the course, and the largest step of the force from one millisecond to the "
        "next",
        "Without a model the force diverges even at 500 Hz, as in the paper; with one, 100 Hz are "
        "enough.",
        {"contact model", "penetration, mm", "felt, N", "step of the force, N", "deviation, mm"}};
    for (std::size_t i = 0; i < kJawsVariants.size(); ++i) {
        double deepest_m = 0.0;
        double most_N = 0.0;
        double jump_N = 0.0;
        double farthest_m = 0.0;
        double last_N = 0.0;
        for (const JawsSample& sample : courses[i]) {
            deepest_m = std::max(deepest_m, sample.penetration_m);
            most_N = std::max(most_N, sample.felt_N);
            jump_N = std::max(jump_N, std::abs(sample.felt_N - last_N));
            farthest_m = std::max(farthest_m, sample.deviation_m);
            last_N = sample.felt_N;
        }
        sheet.add({kJawsVariants[i].name, rounded(1.0e3 * deepest_m, 3), rounded(most_N, 2),
                   rounded(jump_N, 2), rounded(1.0e3 * farthest_m, 2)});
    }
    return sheet;
}

Report run_contact_thread(Run& run) {
    std::vector<std::vector<JawsSample>> courses;
    for (const JawsVariant& variant : kJawsVariants) {
        run.progress(static_cast<double>(courses.size()) / kJawsVariants.size(), variant.name);
        courses.push_back(test::run_jaws(variant.settings));
    }
    Report report;
    for (const JawsQuantity& quantity : kJawsQuantities) {
        report.emplace_back(make_jaws_chart(quantity, courses));
    }
    report.emplace_back(make_jaws_sheet(courses));
    return report;
}

const Registration kContactThread{
    {"contact-thread",
     "two jaws bite: contact found fast and slowly, with and without a model of it",
     run_contact_thread}};

}  // namespace
}  // namespace fulcrum::bench
