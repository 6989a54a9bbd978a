#include "tests/bench/harness/curve.h"
#include "tests/support/linear_wall.h"
#include "tests/support/wall_trial.h"

namespace fulcrum::bench {
namespace {

// The stiffness of the virtual coupling: how far what is felt falls short of a rigid wall, and how far from shaking it is.

using namespace z_width;

std::vector<double> choose_stiffnesses(const Run& run) {
    return run.pick<std::vector<double>>(
        {50.0, 100.0, 200.0, 300.0, 500.0, 700.0, 1000.0, 1400.0, 2000.0, 3000.0, 4000.0, 5000.0,
         7000.0, 1.0e4, 1.4e4, 2.0e4},
        {100.0, 500.0, 2000.0, 8000.0});
}

WallTrial make_trial(const HumanImpedance& human, double stiffness) {
    WallTrial trial = make_tap(human);
    trial.stiffness_N_per_m = stiffness;
    trial.damping_Ns_per_m = CouplingSettings{}.damping_Ns_per_m;
    return trial;
}

// How much softer the hand finds the wall than a rigid one, which would keep it at the surface and give it k_h times the
// way that it presses: the depth that is left is the same share of that way as the missing force is of that force.
double measure_error_percent(const WallTrial& trial) {
    const WallCourse course = run_wall_trial(trial);
    return course.is_stable() ? 100.0 * course.last.depth_m / trial.press_m : kNone;
}

const std::vector<std::pair<std::string, HumanImpedance>>& hands() {
    static const std::vector<std::pair<std::string, HumanImpedance>> list{
        {"fingertip", kFingertip}, {"arm", kArm}, {"posture", kPosture}};
    return list;
}

LineChart run_error(const Run& run) {
    LineChart chart;
    chart.name = "coupling-stiffness-error";
    chart.title = "Stiffness of the coupling: what is missing from a rigid wall";
    chart.work =
        "A hand presses 4 mm into a rigid wall through the coupling, on a simulated desktop arm at "
        "1 kHz, with the program's damping; the error is the depth that is left, in per cent of "
        "the way pressed. A gap: the hand shook.";
    chart.reference = "k_h / (k_h + K): hand and coupling as two springs";
    chart.advice =
        "Double the stiffness only while the other chart allows it: past ten times the hand's own "
        "stiffness each doubling takes away less than five per cent.";
    chart.x = {"stiffness of the coupling", "N/m", true};
    chart.y = {"depth left, of the way pressed", "%", true};
    for (const auto& [name, human] : hands()) {
        const std::vector<double> stiffnesses = choose_stiffnesses(run);
        chart.trace(name, LineStyle::measured, stiffnesses, [&hand = human](double stiffness) {
            return measure_error_percent(make_trial(hand, stiffness));
        });
        chart.trace("two springs, " + name, LineStyle::theory, stiffnesses,
                    [k = human.stiffness_N_per_m](double stiffness) {
                        return 100.0 * k / (k + stiffness);
                    });
    }
    const double standard = CouplingSettings{}.stiffness_N_per_m;
    chart.lines.push_back({"default, fingertip",
                           LineStyle::dots,
                           {standard},
                           {measure_error_percent(make_trial(kFingertip, standard))}});
    return chart;
}

LineChart run_margin(const Run& run) {
    LineChart chart;
    chart.name = "coupling-stiffness-margin";
    chart.title = "Stiffness of the coupling: how far from shaking";
    chart.work =
        "For the same hands the largest stable stiffness, divided by the coupling's: below 1 the "
        "hand shakes. At 1 and 4 kHz, with the program's damping.";
    chart.reference =
        "dashed: 2 b / T, what a wall without damping may have to be passive whoever holds the "
        "arm, with the arm's own viscous friction b of 0.5 Ns/m; the program's damping is more "
        "than b, and with it no stiffness is passive for every hand";
    chart.advice =
        "Keep a margin of two for the hand that nobody tried; a faster loop buys stiffness.";
    chart.x = {"stiffness of the coupling", "N/m", true};
    chart.y = {"largest stable stiffness over the coupling's", "", true};
    const auto add = [&](const std::string& name, LineStyle style, double largest) {
        chart.trace(name, style, choose_stiffnesses(run),
                    [&](double stiffness) { return largest / stiffness; });
    };
    double standard_largest = kNone;
    for (const double rate_Hz : {1000.0, 4000.0}) {
        for (const auto& [name, human] : hands()) {
            WallTrial trial = make_trial(human, 0.0);
            trial.rate_Hz = rate_Hz;
            const double largest = find_largest_stiffness(trial).value_or(kNone);
            add(name + ", " + to_text(0.001 * rate_Hz) + " kHz", LineStyle::measured, largest);
            if (rate_Hz == 1000.0 && name == "fingertip") {
                standard_largest = largest;
            }
        }
        add("passive, " + to_text(0.001 * rate_Hz) + " kHz", LineStyle::theory,
            2.0 * make_desktop_arm().damping_Ns_per_m * rate_Hz);
    }
    const double standard = CouplingSettings{}.stiffness_N_per_m;
    chart.lines.push_back(
        {"default, fingertip", LineStyle::dots, {standard}, {standard_largest / standard}});
    return chart;
}

Report run_coupling_stiffness(Run& run) {
    Report report;
    report.emplace_back(run_error(run));
    run.progress(0.3, "margins");
    report.emplace_back(run_margin(run));
    return report;
}

const Registration kCouplingStiffness{
    {"coupling-stiffness", "stiffness of the virtual coupling against error and stability",
     run_coupling_stiffness}};

// Update rate against the largest stable wall: by theory for the worst hand, by eigenvalues and in time for given ones.

constexpr double kDeviceDamping_Ns_per_m = 0.5;

std::vector<double> choose_rates(const Run& run) {
    return run.pick<std::vector<double>>(
        {250.0, 350.0, 500.0, 700.0, 1000.0, 1400.0, 2000.0, 2800.0, 4000.0, 8000.0},
        {500.0, 1000.0, 4000.0});
}

// In time, on an arm with an encoder's steps.
void trace_rendered(const Run& run, const std::string& name, const HumanImpedance& human,
                    double dry_friction_N, LineChart& chart) {
    chart.trace(name, LineStyle::measured, choose_rates(run), [&](double rate_Hz) {
        WallTrial trial = make_tap(human);
        trial.arm.damping_Ns_per_m = kDeviceDamping_Ns_per_m;
        trial.arm.dry_friction_N = dry_friction_N;
        trial.rate_Hz = rate_Hz;
        return find_largest_stiffness(trial).value_or(kNone);
    });
}

// By eigenvalues, both ways, without steps and dry friction.
void trace_linear(const Run& run, const std::string& name, double mass_kg,
                  const HumanImpedance& human, LineChart& chart) {
    chart.trace(name, LineStyle::dots, choose_rates(run), [&](double rate_Hz) {
        LinearWall wall;
        wall.period_s = 1.0 / rate_Hz;
        wall.device_damping_Ns_per_m = kDeviceDamping_Ns_per_m;
        wall.modes = {{mass_kg + human.mass_kg, human.damping_Ns_per_m, human.stiffness_N_per_m}};
        return find_linear_boundary(wall, 1e-4);
    });
}

Report run_wall_rate(Run& run) {
    constexpr double kHeavy_kg = 30.0;
    LineChart chart;
    chart.name = "wall-rate";
    chart.title = "Update rate and the stiffest stable wall";
    chart.work =
        "The largest stiffness of a wall F = K d on an arm of 45 g with 0.5 Ns/m of its own: in "
        "time, tapped from 10 mm away, with steps of 55 um, of which one alone asks for all the "
        "arm's 10 N at 182 kN/m, where the lines end; and by the eigenvalues of one period, "
        "without steps.";
    chart.reference = "K = 2 b / T, passive whoever holds the arm (Colgate and Schenkel 1997)";
    chart.advice =
        "Choose the rate from the stiffness wanted, not from habit: the worst hand allows K = 2 b "
        "times the rate, a fingertip several times more.";
    chart.x = {"rate", "Hz", true};
    chart.y = {"largest stable stiffness", "N/m", true};
    chart.trace("passive: 2 b / T", LineStyle::theory, choose_rates(run),
                [](double rate_Hz) { return 2.0 * kDeviceDamping_Ns_per_m * rate_Hz; });
    trace_linear(run, "30 kg that nobody damps, eigenvalues", kHeavy_kg, kNobody, chart);
    trace_linear(run, "fingertip, eigenvalues", 0.045, kFingertip, chart);
    run.progress(0.1, "in time");
    trace_rendered(run, "fingertip", kFingertip, 0.0, chart);
    run.progress(0.3);
    trace_rendered(run, "arm", kArm, 0.0, chart);
    run.progress(0.5);
    trace_rendered(run, "posture", kPosture, 0.0, chart);
    run.progress(0.7);
    trace_rendered(run, "fingertip, 0.26 N of dry friction", kFingertip, 0.26, chart);
    return {chart};
}

const Registration kWallRate{
    {"wall-rate", "update rate against the stiffest stable wall", run_wall_rate}};

}  // namespace
}  // namespace fulcrum::bench
