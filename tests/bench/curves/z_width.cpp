// The Z-width map: how stiff a wall may be for each damping that it has, against rate, delay, encoder and velocity estimator.
#include "tests/bench/harness/curve.h"
#include "tests/support/linear_wall.h"
#include "tests/support/wall_trial.h"

namespace fulcrum::bench {
namespace {

using namespace z_width;

WallTrial make_base() {
    WallTrial trial = make_tap(kFingertip);
    trial.velocity.method = VelocityMethod::adaptive_window;
    return trial;
}

void trace_boundary(const Run& run, const std::string& name, WallTrial trial, LineChart& chart) {
    const auto dampings =
        run.pick<std::vector<double>>({0.0, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.,
                                       12., 14., 17., 20.0, 25.0, 30.0},
                                      {0.0, 2.0, 8.0, 20.0});
    chart.trace(name, LineStyle::measured, dampings, [&](double damping) {
        trial.damping_Ns_per_m = damping;
        return find_largest_stiffness(trial).value_or(kNone);
    });
}

// Passive for every hand: K = (b - B) / (T/2 + tau), b the device's own damping alone.
void draw_theory(const std::string& name, const WallTrial& trial, LineChart& chart) {
    Line line{name, LineStyle::theory};
    const double b = trial.arm.damping_Ns_per_m;
    for (int i = 0; i < 20; ++i) {
        const double damping = b * i / 20.0;
        line.add(damping, (b - damping) / (0.5 / trial.rate_Hz + trial.arm.delay_s));
    }
    chart.lines.push_back(std::move(line));
}

LineChart make_chart(const std::string& name, const std::string& title, const std::string& advice) {
    LineChart chart;
    chart.name = "z-width-" + name;
    chart.title = title;
    chart.advice = advice;
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

// The base with one thing changed, a line each, and where every hand is passive: beside each line, or once for all.
struct Change {
    std::string name;
    std::function<void(WallTrial&)> make;
};
LineChart compare(const Run& run, LineChart chart, const std::vector<Change>& changes,
                  bool has_theories) {
    for (const Change& change : changes) {
        WallTrial trial = make_base();
        change.make(trial);
        trace_boundary(run, change.name, trial, chart);
        if (has_theories) {
            draw_theory("passive, " + change.name, trial, chart);
        }
    }
    if (!has_theories) {
        draw_theory("passive", make_base(), chart);
    }
    return chart;
}

// One change for each of some numbers.
std::vector<Change> make_changes(std::initializer_list<double> numbers, const std::string& unit,
                                 void (*make)(WallTrial&, double)) {
    std::vector<Change> changes;
    for (const double number : numbers) {
        changes.push_back(
            {to_text(number) + " " + unit, [=](WallTrial& trial) { make(trial, number); }});
    }
    return changes;
}

LineChart run_rates(const Run& run) {
    LineChart chart = compare(
        run,
        make_chart("rate", "Stable walls against the rate of the haptic loop",
                   "Run the loop as fast as the device takes it: each doubling of the rate about "
                   "doubles the stiffness that a fingertip may meet, and that every hand may while "
                   "B is less than the device's own damping; a wall with more, as the program's "
                   "coupling, is stable for given hands only."),
        make_changes({500.0, 1000.0, 2000.0, 4000.0}, "Hz",
                     [](WallTrial& trial, double rate_Hz) { trial.rate_Hz = rate_Hz; }),
        true);
    const CouplingSettings coupling;
    chart.lines.push_back({"the program's coupling",
                           LineStyle::dots,
                           {coupling.damping_Ns_per_m},
                           {coupling.stiffness_N_per_m}});
    return chart;
}

LineChart run_delays(const Run& run) {
    return compare(
        run,
        make_chart("delay", "Stable walls against the delay of the force, 1 kHz",
                   "Write the force in the round that read the pose: half a period of delay costs "
                   "as much as half the rate."),
        make_changes(
            {0.0, 0.5, 1.0, 2.0}, "ms",
            [](WallTrial& trial, double delay_ms) { trial.arm.delay_s = 0.001 * delay_ms; }),
        true);
}

LineChart run_encoders(const Run& run) {
    return compare(
        run,
        make_chart(
            "encoder", "Stable walls against the step of the encoder, 1 kHz",
            "Spend on rate and delay before the encoder: up to 10 Ns/m steps of 10 to 200 um lie "
            "within 1.4 times of one another, and with more damping 55 um pay over 200 um but 10 "
            "um over 55 um no more."),
        make_changes({0.0, 10.0, 55.0, 200.0}, "um",
                     [](WallTrial& trial, double step_um) {
                         trial.arm.position_resolution_m = 1.0e-6 * step_um;
                         // The least there is, for an encoder without steps.
                         trial.velocity.noise_bound_m = 1.0e-9;
                     }),
        false);
}

LineChart run_frictions(const Run& run) {
    return compare(
        run,
        make_chart(
            "friction", "Stable walls against the arm's dry friction, 1 kHz",
            "Do not count on friction: 0.26 N of it makes the wall that stills this tap several "
            "times as stiff, and none of that is there for a hand that friction does not hold."),
        make_changes(
            {0.0, 0.05, 0.26}, "N",
            [](WallTrial& trial, double friction_N) { trial.arm.dry_friction_N = friction_N; }),
        false);
}

LineChart run_filters(const Run& run) {
    const auto by = [](VelocityMethod method) {
        return [method](WallTrial& trial) { trial.velocity.method = method; };
    };
    return compare(
        run,
        make_chart("velocity", "Stable walls against the estimator of velocity, 1 kHz",
                   "Up to 4 Ns/m all serve; then one step of the encoder is felt through the plain "
                   "difference first and through the low pass next, and what needs much damping "
                   "needs the window or the Kalman filter."),
        {{"finite difference", by(VelocityMethod::finite_difference)},
         {"80 Hz low pass", by(VelocityMethod::filtered_difference)},
         {"adaptive window", by(VelocityMethod::adaptive_window)},
         {"Kalman", by(VelocityMethod::kalman)}},
        false);
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
    LineChart chart = make_chart(
        "worst-hand", "Stable walls for the worst hands",
        "For a wall that must hold under any hand, take the formula as it stands: the worst hands "
        "leave nothing over.");
    chart.work =
        "The boundary by the eigenvalues of one period of a wall both ways, on an arm with 2 Ns/m "
        "of its own, the lowest over two hands: 30 kg that nobody damps, and one with resonances "
        "at the odd multiples of the Nyquist frequency (twelve, in a quick run four).";
    chart.reference = "dashed: K T/2 + |B| = b (Colgate and Schenkel 1997)";
    chart.y.logarithmic = false;
    for (const double rate_Hz : {500.0, 1000.0, 2000.0, 4000.0}) {
        Line measured{to_text(rate_Hz) + " Hz"};
        Line theory{"formula, " + to_text(rate_Hz) + " Hz", LineStyle::theory};
        const int n = run.pick(10, 4);
        for (int i = -n; i <= n; ++i) {
            const double damping = kDeviceDamping * i / n;
            measured.add(damping, find_worst_boundary(run, rate_Hz, kDeviceDamping, damping));
            theory.add(damping, 2.0 * rate_Hz * (kDeviceDamping - std::abs(damping)));
        }
        chart.lines.push_back(measured);
        chart.lines.push_back(theory);
    }
    return chart;
}

Report run_z_width(Run& run) {
    struct Part {
        double begins;
        const char* what;
        LineChart (*make)(const Run&);
    };
    Report report;
    for (const Part& part :
         {Part{0.0, "worst hands", run_worst_hands}, Part{0.1, "rates", run_rates},
          Part{0.5, "delays", run_delays}, Part{0.7, "encoders", run_encoders},
          Part{0.8, "dry friction", run_frictions},
          Part{0.9, "velocity estimators", run_filters}}) {
        run.progress(part.begins, part.what);
        report.emplace_back(part.make(run));
    }
    return report;
}

const Registration kZWidth{
    {"z-width", "how stiff and damped a wall may be, against rate, delay, encoder and estimator",
     run_z_width}};

}  // namespace
}  // namespace fulcrum::bench
