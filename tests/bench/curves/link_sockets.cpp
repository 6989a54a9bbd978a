// The map of link_stability.cpp in real time, over sockets of this computer, beside the same walls on simulated lines under one clock.
#include "tests/support/link_sockets.h"

#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

using test_link::LinkTrial;
using test_link::SocketCourse;

constexpr double kSocketThrown_J = 0.1;
constexpr double kSocketSoftest_N_per_m = 50.0;
constexpr double kSocketStiffest_N_per_m = 3200.0;

// How evenly the threads ran in all trials.
struct SocketPace {
    double late_99_s = 0.0;
    std::uint64_t misses = 0;
};

// Up by twos until the hand is thrown; the stiffest that did not.
template <class IsQuiet>
double find_stiffest_by_twos(LinkTrial trial, const IsQuiet& is_quiet) {
    double stiffest = kNone;
    for (double k = kSocketSoftest_N_per_m; k <= kSocketStiffest_N_per_m; k *= 2.0) {
        trial.stiffness_N_per_m = k;
        if (!is_quiet(trial)) {
            break;
        }
        stiffest = k;
    }
    return stiffest;
}

Report run_link_sockets(Run& run) {
    LineChart chart;
    chart.name = "link-sockets";
    chart.title = "Stable walls over real sockets, fingertip";
    chart.x = {"delay each way", "ms", false};
    chart.y = {"largest stable stiffness", "N/m", true};
    chart.reference = "the same walls under one clock (dashed), as in link-stability";
    chart.advice =
        "What is stable under one clock is so between two threads over sockets as long as both "
        "keep their rounds; look at the lateness in the heading before a difference is believed.";
    const auto delays_ms = run.pick<std::vector<double>>({0.0, 5.0, 10.0, 20.0}, {10.0});
    const double trial_s = run.pick(3.0, 1.0);
    SocketPace pace;
    double share = 0.0;
    for (const double loss : {0.0, 0.05}) {
        for (const bool balances : {true, false}) {
            const std::string name = std::string(loss > 0.0 ? "5 % in bursts of 10" : "no loss") +
                                     (balances ? "" : ", no balance");
            Line felt{name, LineStyle::measured, delays_ms, {}};
            Line simulated{name + ", one clock", LineStyle::theory, delays_ms, {}};
            for (const double delay_ms : delays_ms) {
                LinkTrial trial;
                trial.faults = {
                    .loss = loss, .burst = loss > 0.0 ? 10 : 1, .delay_s = 1e-3 * delay_ms};
                trial.balances_energy = balances;
                trial.seconds = trial_s;
                simulated.y.push_back(find_stiffest_by_twos(trial, [](const LinkTrial& t) {
                    const test_link::LinkCourse course = test_link::run_link_trial(t);
                    return course.linked && course.given_J < kSocketThrown_J;
                }));
                felt.y.push_back(find_stiffest_by_twos(trial, [&](const LinkTrial& t) {
                    const SocketCourse course = test_link::run_socket_trial(t);
                    pace.late_99_s = std::max(pace.late_99_s, course.late_99_s);
                    pace.misses += course.misses;
                    return course.felt.linked && course.felt.given_J < kSocketThrown_J;
                }));
                share += 1.0 / (4.0 * static_cast<double>(delays_ms.size()));
                run.progress(std::min(share, 1.0), name);
            }
            chart.lines.push_back(felt);
            chart.lines.push_back(simulated);
        }
    }
    chart.work =
        "As link-stability, in real time: haptic loop and arm's server on threads of their own at "
        "1 kHz, UDP sockets of this computer between them, packets delayed and lost on the way; "
        "three seconds a wall, one in a quick run, doubled until the hand is given more than 0.1 "
        "J. Rounds of the arm "
        "began at most " +
        to_text(1e3 * pace.late_99_s) + " ms late (99 %, worst trial), " +
        std::to_string(pace.misses) + " rounds of both were missed in all.";
    return {chart};
}

const Registration kLinkSockets{{"link-sockets",
                                 "the same in real time over sockets, beside the simulated line",
                                 run_link_sockets}};

}  // namespace
}  // namespace fulcrum::bench
