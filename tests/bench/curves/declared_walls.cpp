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

Report run_declared_walls(Run& run) {
    Report report;
    run.progress(0.0, "stiffness");
    report.emplace_back(run_felt(run));
    run.progress(0.33, "swing");
    report.emplace_back(run_swing(run));
    run.progress(0.67, "energy");
    report.emplace_back(run_excess(run));
    return report;
}

const Registration kDeclaredWalls{
    {"declared-walls", "walls that a lesson declares, as they ship: felt stiffness, rest, energy",
     run_declared_walls}};

}  // namespace
}  // namespace fulcrum::bench
