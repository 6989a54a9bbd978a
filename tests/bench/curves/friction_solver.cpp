#include "haptics/point/friction_problem.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/contact_stack.h"
#include "tests/support/wander.h"

namespace fulcrum::bench {
namespace {

// What a step of a stack costs the solvers of contacts, and how near they come: cubes on each other as bare contact problems, without
// collision detection, at rest and dropped.

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

// Rounds of the friction solver where a corner holds the proxy: what each costs, and how far it stays from the solution. Beside it
// the plain Gauss-Seidel sweep that solves push and drag of one plane after the other.

constexpr int kReferenceRounds = 5000;
constexpr double kSettled_m = 1.0e-12;

struct Corner {
    Vector3 hand{Vector3::Zero()};
    std::vector<FrictionPlane> planes;
};
using Solver = double (*)(const Vector3&, std::span<FrictionPlane>, int);

// The hand is some centimetres behind two or three planes that met at the proxy, and goes on sliding. In every other corner
// the planes are solids of their own that have moved by half a millimetre, at 1 kHz 0.5 m/s.
std::vector<Corner> make_corners(int n) {
    Random random(12);
    std::vector<Corner> corners;
    while (static_cast<int>(corners.size()) < n) {
        Corner corner;
        const std::size_t count = corners.size() % 2 == 0 ? 2 : 3;
        while (corner.planes.size() < count) {
            const Vector3 normal = random.direction();
            const bool apart = std::ranges::all_of(corner.planes, [&](const FrictionPlane& other) {
                return std::abs(normal.dot(other.normal)) <= 0.7;
            });
            if (apart) {
                const double dynamic = 0.1 + 0.3 * std::abs(random.uniform());
                corner.planes.push_back({.normal = normal,
                                         .anchor = corners.size() % 4 < 2
                                                       ? Vector3(Vector3::Zero())
                                                       : Vector3(0.0005 * random.direction()),
                                         .law = {1.3 * dynamic, dynamic, 0.0},
                                         .was_stuck = false});
            }
        }
        for (const FrictionPlane& plane : corner.planes) {
            corner.hand -= 0.02 * (1.0 + random.uniform()) * plane.normal;
        }
        corner.hand += 0.01 * random.direction();
        std::vector<FrictionPlane> solved = corner.planes;
        if (solve_friction(corner.hand, solved, kReferenceRounds) <= kSettled_m) {
            corners.push_back(std::move(corner));
        }
    }
    return corners;
}

// Push and drag of one plane after the other, as the point stands without it.
double sweep_planes(const Vector3& hand, std::span<FrictionPlane> planes, int rounds) {
    Vector3 held = Vector3::Zero();
    for (FrictionPlane& plane : planes) {
        plane.push_m = 0.0;
        plane.drag.setZero();
    }
    for (int round = 0; round < rounds; ++round) {
        for (FrictionPlane& plane : planes) {
            held -= plane.push_m * plane.normal + plane.drag;
            std::array alone{plane};
            solve_friction(hand + held, alone, 1);
            plane = alone[0];
            held += plane.push_m * plane.normal + plane.drag;
        }
    }
    return 0.0;
}

Vector3 find_place(const Corner& corner, Solver solve, int rounds) {
    std::vector<FrictionPlane> planes = corner.planes;
    solve(corner.hand, planes, rounds);
    Vector3 place = corner.hand;
    for (const FrictionPlane& plane : planes) {
        place += plane.push_m * plane.normal + plane.drag;
    }
    return place;
}

CostPoint measure_rounds(const std::string& name, Solver solve, int rounds,
                         const std::vector<Corner>& corners) {
    std::vector<double> errors_mm;
    for (const Corner& corner : corners) {
        const Vector3 right = find_place(corner, solve_friction, kReferenceRounds);
        errors_mm.push_back(1000.0 * (find_place(corner, solve, rounds) - right).norm());
    }
    std::sort(errors_mm.begin(), errors_mm.end());
    std::size_t next = 0;
    std::array<FrictionPlane, 3> planes;
    const Cost cost = measure_cost([&] {
        const Corner& corner = corners[next++ % corners.size()];
        std::copy(corner.planes.begin(), corner.planes.end(), planes.begin());
        solve(corner.hand, std::span(planes.data(), corner.planes.size()), rounds);
        keep(planes);
    });
    return {name,
            static_cast<double>(rounds),
            errors_mm[errors_mm.size() * 95 / 100],
            cost,
            {errors_mm[errors_mm.size() / 2]}};
}

Report run_friction_solver(Run& run) {
    CostCurve curve;
    curve.name = "friction-solver";
    curve.title = "Friction in a corner: rounds of the solver";
    curve.work =
        "A hand some centimetres behind two or three planes with friction; the error is how far "
        "the proxy's goal lies from the solution, 95 % of all corners are better.";
    curve.reference = "converged: the same laws after 5000 rounds, changes below 1e-12 m";
    curve.advice =
        "Two rounds solve a corner of one solid, and most others; where three solids move against "
        "each other, the default, 16, leaves some tenths of a millimetre in the worst of them. One "
        "plane alone is exact in closed form, whatever the number.";
    curve.knob = {"rounds at most", "", true};
    curve.error = {"distance from the solution, 95 %", "mm", true};
    curve.extras = {{"the same, median", "mm", true}};
    curve.default_series = "pushes together";
    curve.default_knob = 16.0;
    const std::vector<Corner> corners = make_corners(run.quick() ? 60 : 1000);
    for (const int rounds : {1, 2, 4, 8, 16, 32, 64}) {
        curve.points.push_back(measure_rounds("pushes together", solve_friction, rounds, corners));
        curve.points.push_back(measure_rounds("plane after plane", sweep_planes, rounds, corners));
    }
    return {curve};
}

const Registration kFrictionSolver{
    {"friction-solver", "rounds of the friction solver in a corner", run_friction_solver}};

}  // namespace
}  // namespace fulcrum::bench
