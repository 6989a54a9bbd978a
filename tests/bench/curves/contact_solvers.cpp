// What a step of a stack costs the solvers of contacts, and how near they come: cubes on each other as bare contact problems, without
// collision detection, at rest and dropped.
#include "tests/bench/harness/curve.h"
#include "tests/support/contact_stack.h"

namespace fulcrum::bench {
namespace {

struct Stand {
    Cost cost;
    double residual_m_per_s = 0.0;  // the largest of all steps
    double drift_mm = 0.0;
};

Stand measure_stack(const ContactStackSettings& stack, const ContactSolverSettings& solver,
                    int n_steps) {
    ContactStack cubes(stack, solver);
    Stand stand;
    std::vector<double> us;
    for (int k = 0; k < n_steps; ++k) {
        cubes.prepare();
        SolveReport report;
        us.push_back(time_once([&] { report = cubes.solve(); }).clock_us);
        cubes.finish();
        stand.residual_m_per_s = std::max(stand.residual_m_per_s, report.residual_m_per_s);
    }
    stand.cost = summarise(std::move(us));
    stand.drift_mm = 1.0e3 * cubes.drift_m();
    return stand;
}

ContactSolverSettings settings_of(ContactMethod method, double knob) {
    ContactSolverSettings settings;
    settings.method = method;
    if (method == ContactMethod::iterative) {
        settings.max_iterations = static_cast<int>(knob);
    } else {
        settings.tolerance_m_per_s = knob;
    }
    return settings;
}

CostCurve measure_accuracy(Run& run) {
    CostCurve curve;
    curve.name = "contact-solvers";
    curve.title = "Solvers of contacts on a stack of ten cubes";
    curve.work =
        "Ten cubes of 0.1 m and 1 kg, friction 0.6, dropped 5 mm apart, then at rest, 1 ms a step; "
        "only the solver is timed. The default tolerance, 1e-8 m/s, is the one that a program "
        "takes.";
    curve.reference = "exact: the complementarity that every answer must meet";
    curve.advice =
        "Take newton: it is the fastest that is exact, and at rest it solves nothing; rounds "
        "contact after contact are no match for a stack.";
    curve.knob = {"tolerance in m/s, or rounds", "", true};
    curve.error = {"largest residual of a step", "m/s", true};
    curve.extras = {{"sideways drift", "mm", true}};
    curve.default_series = "newton";
    curve.default_knob = ContactSolverSettings{}.tolerance_m_per_s;
    const int n_steps = run.pick(4000, 400);
    for (const ContactMethod method : kContactMethods) {
        const std::vector<double> knobs = method == ContactMethod::iterative
                                              ? std::vector<double>{5, 20, 80, 320}
                                              : std::vector<double>{1e-10, 1e-8, 1e-6, 1e-4};
        for (const double knob : knobs) {
            run.progress(0.1 * static_cast<double>(curve.points.size() % 10),
                         std::string(to_string(method)));
            const Stand stand = measure_stack({.n_cubes = 10, .start_gap_m = 0.005},
                                              settings_of(method, knob), n_steps);
            curve.add(std::string(to_string(method)), knob, stand.residual_m_per_s, stand.cost,
                      {stand.drift_mm});
        }
    }
    return curve;
}

LineChart measure_growth(Run& run) {
    LineChart chart;
    chart.name = "contact-solvers-growth";
    chart.title = "A step of a stack at rest against its cubes";
    chart.work =
        "Stacks that stand from the start, the same cubes, 1 ms a step; the median of a step, only "
        "the solver timed; the heavy one has 100 kg on top.";
    chart.x = {"cubes", "", true};
    chart.y = {"time a step", "µs", true};
    const auto numbers = run.pick<std::vector<double>>({1, 2, 4, 6, 10, 20}, {1, 4, 10});
    std::string grows;
    for (const ContactMethod method : kContactMethods) {
        for (const double top_kg : {1.0, 100.0}) {
            if (top_kg > 1.0 && method != ContactMethod::newton) {
                continue;
            }
            const std::string name =
                std::string(to_string(method)) + (top_kg > 1.0 ? ", 100:1 on top" : "");
            const ContactSolverSettings settings =
                settings_of(method, method == ContactMethod::iterative ? 60.0 : 1.0e-8);
            chart.trace(name, LineStyle::measured, numbers, [&](double n) {
                return measure_stack({.n_cubes = static_cast<int>(n), .top_mass_kg = top_kg},
                                     settings, run.pick(2000, 200))
                    .cost.median_us;
            });
            grows += (grows.empty() ? "" : ", ") + name + " " +
                     to_text(rounded(find_power(chart.lines.back()), 2));
        }
    }
    chart.advice = "Time grows as the number of cubes to the power of: " + grows + ".";
    return chart;
}

Report run_contact_solvers(Run& run) {
    CostCurve accuracy = measure_accuracy(run);
    return {std::move(accuracy), measure_growth(run)};
}

const Registration kContactSolvers{{"contact-solvers",
                                    "solvers of contacts on stacks: time against residual and "
                                    "drift, and growth with the cubes",
                                    run_contact_solvers}};

}  // namespace
}  // namespace fulcrum::bench
