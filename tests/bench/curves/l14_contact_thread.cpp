// Otaduy & Lin 2005, figure 6, on jaws of our own: penetration, the contact thread's rate, coupling deviation and felt force over 900 ms, with
// contact found each millisecond or 100 times a second, by planes, by their linearised model, and without a model.
#include "tests/bench/curves/l14_charts.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/jaws.h"

namespace fulcrum::bench {
namespace {

using test::JawsSample;
using test::JawsSettings;

struct Variant {
    const char* name;
    JawsSettings settings;
};
const std::array<Variant, 5> kVariants{
    {{"planes, each step", {}},
     {"linearised, each step", {.model = PenaltyModel::linearised}},
     {"planes, 100 Hz", {.round_s = 0.01}},
     {"linearised, 100 Hz", {.model = PenaltyModel::linearised, .round_s = 0.01}},
     {"no model, 500 Hz", {.model = PenaltyModel::held, .round_s = 0.002}}}};

using Quantity = CourseQuantity<JawsSample>;
constexpr double kAxisEnd_N = 10.0;  // what diverges ends there
const std::array<Quantity, 4> kQuantities{
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

LineChart make_chart(const Quantity& quantity,
                     const std::vector<std::vector<JawsSample>>& courses) {
    LineChart chart = make_course_chart(quantity, kVariants, courses);
    chart.work =
        "an upper jaw of 20 k triangles and 10 g on a coupling of 500 N/m bites into a lower one "
        "and grinds on it, contacts of 5 kN/m; lines end where they leave the axes";
    chart.reference =
        "after Otaduy & Lin 2005, figure 6, whose jaws have 40 k triangles and whose contact "
        "thread is slowed by a finer tolerance; here it is slowed by the clock";
    return chart;
}

Sheet make_sheet(const std::vector<std::vector<JawsSample>>& courses) {
    Sheet sheet{
        "l14-jaws",
        "Two jaws, with and without a model of contact",
        "the worst of the course, and the largest step of the force from one millisecond to the "
        "next",
        "Without a model the force diverges even at 500 Hz, as in the paper; with one, 100 Hz are "
        "enough.",
        {"contact model", "penetration, mm", "felt, N", "step of the force, N", "deviation, mm"}};
    for (std::size_t i = 0; i < kVariants.size(); ++i) {
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
        sheet.add({kVariants[i].name, rounded(1.0e3 * deepest_m, 3), rounded(most_N, 2),
                   rounded(jump_N, 2), rounded(1.0e3 * farthest_m, 2)});
    }
    return sheet;
}

Report run_contact_thread(Run& run) {
    std::vector<std::vector<JawsSample>> courses;
    for (const Variant& variant : kVariants) {
        run.progress(static_cast<double>(courses.size()) / kVariants.size(), variant.name);
        courses.push_back(test::run_jaws(variant.settings));
    }
    Report report;
    for (const Quantity& quantity : kQuantities) {
        report.emplace_back(make_chart(quantity, courses));
    }
    report.emplace_back(make_sheet(courses));
    return report;
}

const Registration kContactThread{
    {"contact-thread",
     "two jaws bite: contact found fast and slowly, with and without a model of it",
     run_contact_thread}};

}  // namespace
}  // namespace fulcrum::bench
