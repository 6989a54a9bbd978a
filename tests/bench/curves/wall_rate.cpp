// Update rate against the largest stable wall: by theory for the worst hand, by eigenvalues and in time for given ones.
#include "tests/bench/harness/curve.h"
#include "tests/support/linear_wall.h"
#include "tests/support/wall_trial.h"

namespace fulcrum::bench {
namespace {

using namespace z_width;

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
