// The Z-width map: how stiff a wall may be for each damping that it has, against rate, delay, encoder and velocity estimator.
#include "tests/bench/harness/csv.h"
#include "tests/bench/harness/registry.h"
#include "tests/support/linear_wall.h"
#include "tests/support/wall_trial.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::bench {
namespace {

using namespace z_width;

// A fingertip on a desktop arm comes from 10 mm above the wall and presses 4 mm into it. Without the arm's dry friction,
// which swallows most vibrations: a chart of its own shows what it does.
WallTrial make_base() {
    WallTrial trial;
    trial.arm = make_desktop_arm();
    trial.arm.human = kFingertip;
    trial.arm.max_force_N = 10.0;  // so that the wall, not the motor, sets the boundary
    trial.arm.dry_friction_N = 0.0;
    trial.start_m = 0.01;
    trial.press_m = 0.004;
    trial.velocity.method = VelocityMethod::adaptive_window;
    return trial;
}

std::vector<double> choose_dampings(const Run& run) {
    return run.quick() ? std::vector<double>{0.0, 2.0, 8.0, 20.0}
                       : std::vector<double>{0.0, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0,  4.0,  5.0,
                                             6.0, 8.0,  10., 12., 14., 17., 20.0, 25.0, 30.0};
}

Line trace_boundary(const Run& run, const std::string& name, WallTrial trial) {
    Line line{name, LineStyle::measured, choose_dampings(run), {}};
    for (const double damping : line.x) {
        trial.damping_Ns_per_m = damping;
        line.y.push_back(find_largest_stiffness(trial).value_or(kNone));
    }
    return line;
}

// Passive for every hand: K = (b - B) / (T/2 + tau), b the device's own damping alone.
Line draw_theory(const std::string& name, const WallTrial& trial) {
    Line line{name, LineStyle::theory, {}, {}};
    const double b = trial.arm.damping_Ns_per_m;
    for (int i = 0; i < 20; ++i) {
        line.x.push_back(b * i / 20.0);
        line.y.push_back((b - line.x.back()) / (0.5 / trial.rate_Hz + trial.arm.delay_s));
    }
    return line;
}

LineChart make_chart(const std::string& name, const std::string& title) {
    LineChart chart;
    chart.name = "z-width-" + name;
    chart.title = title;
    chart.work =
        "A fingertip comes from 10 mm away and presses 4 mm into a wall F = K d - B v on a "
        "simulated desktop arm (45 g, 0.5 Ns/m viscous and no dry friction, steps of 55 um, "
        "adaptive window); K is raised by a tenth until the hand no longer comes to rest within "
        "two steps and a ripple of K times a step + 0.52 N, however long it takes, then halved to "
        "2 %. A gap: no wall does.";
    chart.reference =
        "dashed: passive whoever holds the arm, K (T/2 + delay) + |B| < b, with the device's own b "
        "alone (Colgate and Schenkel 1997); beyond b = 0.5 Ns/m there is none";
    chart.x = {"damping B of the wall", "Ns/m", false};
    chart.y = {"largest stable stiffness K", "N/m", true};
    return chart;
}

LineChart run_rates(const Run& run) {
    LineChart chart = make_chart("rate", "Stable walls against the rate of the haptic loop");
    chart.advice =
        "Run the loop as fast as the device takes it: each doubling of the rate about doubles the "
        "stiffness that a fingertip may meet, and that every hand may while B is less than the "
        "device's own damping; a wall with more, as the program's coupling, is stable for given "
        "hands only.";
    for (const double rate_Hz : {500.0, 1000.0, 2000.0, 4000.0}) {
        WallTrial trial = make_base();
        trial.rate_Hz = rate_Hz;
        chart.lines.push_back(trace_boundary(run, to_text(rate_Hz) + " Hz", trial));
        chart.lines.push_back(draw_theory("passive, " + to_text(rate_Hz) + " Hz", trial));
    }
    const CouplingSettings coupling;
    chart.lines.push_back({"the program's coupling",
                           LineStyle::dots,
                           {coupling.damping_Ns_per_m},
                           {coupling.stiffness_N_per_m}});
    return chart;
}

LineChart run_delays(const Run& run) {
    LineChart chart = make_chart("delay", "Stable walls against the delay of the force, 1 kHz");
    chart.advice =
        "Write the force in the round that read the pose: half a period of delay costs as much as "
        "half the rate.";
    for (const double delay_ms : {0.0, 0.5, 1.0, 2.0}) {
        WallTrial trial = make_base();
        trial.arm.delay_s = 0.001 * delay_ms;
        chart.lines.push_back(trace_boundary(run, to_text(delay_ms) + " ms", trial));
        chart.lines.push_back(draw_theory("passive, " + to_text(delay_ms) + " ms", trial));
    }
    return chart;
}

LineChart run_encoders(const Run& run) {
    LineChart chart = make_chart("encoder", "Stable walls against the step of the encoder, 1 kHz");
    chart.advice =
        "Spend on rate and delay before the encoder: up to 10 Ns/m steps of 10 to 200 um lie "
        "within 1.4 times of one another, and with more damping 55 um pay over 200 um but 10 um "
        "over "
        "55 um no more.";
    for (const double step_um : {0.0, 10.0, 55.0, 200.0}) {
        WallTrial trial = make_base();
        trial.arm.position_resolution_m = 1.0e-6 * step_um;
        trial.velocity.noise_bound_m = 1.0e-9;  // the least there is, for an encoder without steps
        chart.lines.push_back(trace_boundary(run, to_text(step_um) + " um", trial));
    }
    chart.lines.push_back(draw_theory("passive", make_base()));
    return chart;
}

LineChart run_frictions(const Run& run) {
    LineChart chart = make_chart("friction", "Stable walls against the arm's dry friction, 1 kHz");
    chart.advice =
        "Do not count on friction: 0.26 N of it makes the wall that stills this tap several times "
        "as stiff, and none of that is there for a hand that friction does not hold.";
    for (const double friction_N : {0.0, 0.05, 0.26}) {
        WallTrial trial = make_base();
        trial.arm.dry_friction_N = friction_N;
        chart.lines.push_back(trace_boundary(run, to_text(friction_N) + " N", trial));
    }
    chart.lines.push_back(draw_theory("passive", make_base()));
    return chart;
}

LineChart run_filters(const Run& run) {
    LineChart chart =
        make_chart("velocity", "Stable walls against the estimator of velocity, 1 kHz");
    chart.advice =
        "Up to 4 Ns/m all serve; then one step of the encoder is felt through the plain difference "
        "first and through the low pass next, and what needs much damping needs the window or the "
        "Kalman filter.";
    const std::vector<std::pair<std::string, VelocityMethod>> methods{
        {"finite difference", VelocityMethod::finite_difference},
        {"80 Hz low pass", VelocityMethod::filtered_difference},
        {"adaptive window", VelocityMethod::adaptive_window},
        {"Kalman", VelocityMethod::kalman}};
    for (const auto& [name, method] : methods) {
        WallTrial trial = make_base();
        trial.velocity.method = method;
        chart.lines.push_back(trace_boundary(run, name, trial));
    }
    chart.lines.push_back(draw_theory("passive", make_base()));
    return chart;
}

// The boundary over the worst hands that the formula has: a heavy one that nobody damps, and one that rings at the Nyquist
// frequency and its odd multiples.
double find_worst_boundary(const Run& run, double rate_Hz, double device_damping, double damping) {
    constexpr double kHeavy_kg = 30.0;
    LinearWall wall;
    wall.period_s = 1.0 / rate_Hz;
    wall.device_damping_Ns_per_m = device_damping;
    wall.damping_Ns_per_m = damping;
    double worst = kStiffestLinear_N_per_m;
    for (const std::vector<Mode>& hand :
         {std::vector<Mode>{{kHeavy_kg, 0.0, 0.0}},
          make_nyquist_hand(run.pick(12, 4), kHeavy_kg, wall.period_s)}) {
        wall.modes = hand;
        const double found = find_linear_boundary(wall, 1e-3);
        worst = std::min(worst, found < 1.0 ? 0.0 : found);
    }
    return worst;
}

LineChart run_worst_hands(const Run& run) {
    constexpr double kDeviceDamping = 2.0;
    LineChart chart = make_chart("worst-hand", "Stable walls for the worst hands");
    chart.work =
        "The boundary by the eigenvalues of one period of a wall both ways, on an arm with 2 Ns/m "
        "of "
        "its own, the lowest over two hands: 30 kg that nobody damps, and one with resonances at "
        "the "
        "odd multiples of the Nyquist frequency (twelve, in a quick run four).";
    chart.reference = "dashed: K T/2 + |B| = b (Colgate and Schenkel 1997)";
    chart.advice =
        "For a wall that must hold under any hand, take the formula as it stands: the worst hands "
        "leave nothing over.";
    chart.y.logarithmic = false;
    for (const double rate_Hz : {500.0, 1000.0, 2000.0, 4000.0}) {
        Line measured{to_text(rate_Hz) + " Hz", LineStyle::measured, {}, {}};
        Line theory{"formula, " + to_text(rate_Hz) + " Hz", LineStyle::theory, {}, {}};
        const int n = run.pick(10, 4);
        for (int i = -n; i <= n; ++i) {
            const double damping = kDeviceDamping * i / n;
            measured.x.push_back(damping);
            measured.y.push_back(find_worst_boundary(run, rate_Hz, kDeviceDamping, damping));
            theory.x.push_back(damping);
            theory.y.push_back(2.0 * rate_Hz * (kDeviceDamping - std::abs(damping)));
        }
        chart.lines.push_back(measured);
        chart.lines.push_back(theory);
    }
    return chart;
}

Report run_z_width(Run& run) {
    Report report;
    report.emplace_back(run_worst_hands(run));
    run.progress(0.1, "rates");
    report.emplace_back(run_rates(run));
    run.progress(0.5, "delays");
    report.emplace_back(run_delays(run));
    run.progress(0.7, "encoders");
    report.emplace_back(run_encoders(run));
    run.progress(0.8, "dry friction");
    report.emplace_back(run_frictions(run));
    run.progress(0.9, "velocity estimators");
    report.emplace_back(run_filters(run));
    return report;
}

const Registration kZWidth{
    {"z-width", "how stiff and damped a wall may be, against rate, delay, encoder and estimator",
     run_z_width}};

}  // namespace
}  // namespace fulcrum::bench
