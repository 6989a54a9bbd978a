// Walls that a lesson declares, as they are shipped: what the plan makes of them for an arm at hand and for longer ways to it, and how they come to rest.
#include "tests/bench/harness/curve.h"
#include "tests/support/declared_wall.h"

namespace fulcrum::bench {
namespace {

constexpr double kDamping_Ns_per_m = 5.0;

LineChart make_chart(const std::string& name, const std::string& title, const std::string& advice) {
    LineChart chart;
    chart.name = "declared-walls-" + name;
    chart.title = title;
    chart.advice = advice;
    chart.work =
        "A fingertip comes from 10 mm above and presses 4 mm into a wall with 5 Ns/m that a lesson "
        "declares, on a simulated desktop arm without its dry friction, at 1 kHz, through plan, "
        "loop, "
        "link and gates as they ship.";
    chart.x = {"declared stiffness", "N/m", true};
    return chart;
}

// A line for an arm at hand, and for each way to one.
void trace_ways(const Run& run, LineChart& chart,
                const std::function<double(const test::DeclaredWallCourse&)>& figure) {
    const auto stiffnesses = run.pick<std::vector<double>>(
        {50.0, 100.0, 200.0, 300.0, 500.0, 700.0, 1000.0, 1400.0, 2000.0, 2800.0, 4000.0, 5000.0},
        {100.0, 1000.0, 5000.0});
    for (const std::optional<double> delay_ms :
         {std::optional<double>{}, std::optional<double>{1.0}, std::optional<double>{5.0},
          std::optional<double>{20.0}}) {
        const std::string name =
            delay_ms ? to_text(*delay_ms) + " ms each way" : std::string("at hand");
        chart.trace(name, LineStyle::measured, stiffnesses, [&](double stiffness) {
            test::DeclaredWall wall;
            wall.stiffness_N_per_m = stiffness;
            wall.damping_Ns_per_m = kDamping_Ns_per_m;
            if (delay_ms) {
                wall.link_delay_s = 1.0e-3 * *delay_ms;
            }
            return figure(test::press_declared_wall(wall));
        });
    }
}

LineChart run_felt(const Run& run) {
    LineChart chart = make_chart("felt", "What is felt of a declared stiffness",
                                 "Declare up to 1000 N/m: beyond that an arm at hand holds up to "
                                 "3750, and each millisecond of the way takes from it.");
    chart.y = {"felt stiffness", "N/m", true};
    trace_ways(run, chart, [](const test::DeclaredWallCourse& course) {
        return course.felt.stiffness_N_per_m;
    });
    return chart;
}

LineChart run_swing(const Run& run) {
    LineChart chart =
        make_chart("swing", "How far a hand still swings that presses a declared wall",
                   "Two steps of the encoder, 0.11 mm, are rest: all walls come to it.");
    chart.y = {"swing of the hand once it is decided", "um", false};
    trace_ways(run, chart, [](const test::DeclaredWallCourse& course) {
        return 1.0e6 * course.wall.last.swing_m;
    });
    return chart;
}

LineChart run_excess(const Run& run) {
    LineChart chart = make_chart(
        "excess", "Energy beyond what a declared wall gives",
        "0.1 mJ is what the passivity stage grants; what an encoder's steps seem to give is "
        "counted too.");
    chart.y = {"most at a time, as the passivity stage counts it", "mJ", false};
    trace_ways(run, chart,
               [](const test::DeclaredWallCourse& course) { return 1.0e3 * course.excess_J; });
    return chart;
}

// Where two springs balance, the second of which saturates.
double find_balance_N(const CouplingSettings& wall, double hand_N_per_m, double press_m) {
    double low_m = 0.0;
    double high_m = press_m;
    for (int i = 0; i < 60; ++i) {
        const double middle_m = 0.5 * (low_m + high_m);
        const bool gives_way =
            compute_spring_force_N(wall, middle_m) < hand_N_per_m * (press_m - middle_m);
        (gives_way ? low_m : high_m) = middle_m;
    }
    return compute_spring_force_N(wall, low_m);
}

LineChart run_saturation(const Run& run) {
    constexpr double kStiffness_N_per_m = 500.0;
    constexpr double kPress_m = 0.016;
    LineChart chart = make_chart("saturation", "What is felt of a wall that saturates",
                                 "Let a spring saturate where something is to yield, dough or a "
                                 "pillow; below what a hand presses with it is felt as force "
                                 "alone, and no hand finds out how stiff it is.");
    chart.work =
        "A hand comes from 10 mm above and presses 16 mm into a wall of 500 N/m and 5 Ns/m that "
        "saturates, even up to half of its force, on a simulated desktop arm without its dry "
        "friction, at 1 kHz, through plan, loop and gate as they ship.";
    chart.reference = "dashed: where the springs of hand and wall balance";
    chart.x = {"most force of the wall", "N"};
    chart.y = {"force at rest", "N"};
    const auto forces_N = run.pick<std::vector<double>>(
        {0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0}, {0.5, 2.0, 5.0});
    for (const auto& [name, human] : {std::pair{"fingertip", kFingertip}, std::pair{"arm", kArm}}) {
        test::DeclaredWall wall{.stiffness_N_per_m = kStiffness_N_per_m,
                                .damping_Ns_per_m = kDamping_Ns_per_m,
                                .human = human,
                                .press_m = kPress_m};
        chart.trace(name, LineStyle::measured, forces_N, [&](double force_N) {
            wall.saturation_N = force_N;
            return test::press_declared_wall(wall).wall.last.force_N;
        });
        chart.trace(std::string("two springs, ") + name, LineStyle::theory, forces_N,
                    [&](double force_N) {
                        const CouplingSettings yielding =
                            saturate({.stiffness_N_per_m = kStiffness_N_per_m},
                                     0.5 * force_N / kStiffness_N_per_m, force_N);
                        return std::min(find_balance_N(yielding, human.stiffness_N_per_m, kPress_m),
                                        make_desktop_arm().max_force_N);
                    });
    }
    return chart;
}

Report run_declared_walls(Run& run) {
    Report report;
    run.progress(0.0, "stiffness");
    report.emplace_back(run_felt(run));
    run.progress(0.33, "swing");
    report.emplace_back(run_swing(run));
    run.progress(0.67, "energy");
    report.emplace_back(run_excess(run));
    run.progress(0.9, "saturation");
    report.emplace_back(run_saturation(run));
    return report;
}

const Registration kDeclaredWalls{
    {"declared-walls",
     "walls that a lesson declares, as they ship: felt stiffness, rest, energy, saturation",
     run_declared_walls}};

}  // namespace
}  // namespace fulcrum::bench
