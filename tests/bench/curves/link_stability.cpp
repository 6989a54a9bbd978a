// How stiff a wall may be over the arm link, against delay and loss, with and without the link's energy balance; and what the
// balance costs in force.
#include "tests/bench/harness/curve.h"
#include "tests/support/link_trial.h"

namespace fulcrum::bench {
namespace {

using test_link::LinkCourse;
using test_link::LinkTrial;
using test_link::run_link_trial;
using test_link::with_slow_presses;

constexpr double kSoftestWall_N_per_m = 20.0;
constexpr double kStiffestWall_N_per_m = 3000.0;
constexpr double kThrown_J =
    0.1;  // more than any of these walls stores: a hand that is given this is thrown

LinkTrial make_link_trial(double delay_s, const HumanImpedance& hand) {
    LinkTrial trial;
    trial.faults.delay_s = delay_s;
    trial.arm.human = hand;
    return trial;
}

bool is_quiet(const LinkCourse& course) {
    return course.linked && course.given_J < kThrown_J && course.trips == 0;
}

// Up by steps of two fifths until the hand is thrown.
double find_stiffest(LinkTrial trial) {
    double stiffest = kNone;
    for (double k = kSoftestWall_N_per_m; k <= kStiffestWall_N_per_m; k *= 1.4) {
        trial.stiffness_N_per_m = k;
        if (!is_quiet(run_link_trial(trial))) {
            break;
        }
        stiffest = k;
    }
    return stiffest;
}

std::vector<double> choose_delays_ms(const Run& run) {
    return run.pick<std::vector<double>>({0.0, 2.0, 5.0, 10.0, 20.0, 30.0, 50.0}, {0.0, 10.0});
}

struct LossKind {
    std::string name;
    double loss;
    int burst;
};

LineChart make_link_chart(const std::string& name, const std::string& title) {
    LineChart chart;
    chart.name = "link-" + name;
    chart.title = title;
    chart.work =
        "A hand on a simulated arm (0.25 kg, 0.2 Ns/m, an encoder's steps of 55 um) wants to be 10 "
        "mm inside a wall F = -K y, four times and then for good, all through haptic loop, link "
        "and arm's server at 1 kHz under one clock; K is raised by two fifths until the hand is "
        "given more than 0.1 J that it did not give, or a gate trips. Loss is in both ways. Solid: "
        "with the energy balance; dashed: without.";
    chart.reference =
        "the same link without its energy balance; the loop's own passivity is on in both";
    chart.x = {"delay each way", "ms", false};
    return chart;
}

LineChart run_stiffest(const Run& run, const std::string& name, const HumanImpedance& hand,
                       const std::vector<LossKind>& losses) {
    LineChart chart = make_link_chart("stability-" + name, "Stable walls over the link, " + name);
    chart.y = {"largest stable stiffness", "N/m", true};
    chart.advice =
        "Let the balance be on: where a delay would throw the hand it is held. Even so keep delays "
        "below 20 ms, where stiff walls keep their force.";
    for (const LossKind& kind : losses) {
        for (const bool balances : {true, false}) {
            chart.trace(kind.name + (balances ? "" : ", no balance"),
                        balances ? LineStyle::measured : LineStyle::theory, choose_delays_ms(run),
                        [&](double delay_ms) {
                            LinkTrial trial = make_link_trial(1e-3 * delay_ms, hand);
                            trial.faults.loss = kind.loss;
                            trial.faults.burst = kind.burst;
                            trial.balances_energy = balances;
                            return find_stiffest(trial);
                        });
        }
    }
    return chart;
}

LineChart run_force(const Run& run) {
    LineChart chart = make_link_chart("force", "What the energy balance leaves of a wall's force");
    chart.work =
        "As in the map of stability, with the balance; the mean force of the last two of eight "
        "seconds, after four seconds in the wall.";
    chart.reference = "where hand and wall, two springs, meet at rest";
    chart.y = {"force felt, of the wall's own", "1", false};
    chart.advice = "A wall that a delay makes active is felt softer, not louder.";
    for (const double stiffness : {100.0, 300.0, 900.0}) {
        chart.trace(to_text(stiffness) + " N/m", LineStyle::measured, choose_delays_ms(run),
                    [&](double delay_ms) {
                        LinkTrial trial = make_link_trial(1e-3 * delay_ms, kArm);
                        trial.stiffness_N_per_m = stiffness;
                        const double hand = kArm.stiffness_N_per_m;
                        const double rest_N = trial.press_m * hand * stiffness / (hand + stiffness);
                        return -run_link_trial(trial).force_N / rest_N;
                    });
    }
    return chart;
}

// What a wall that stores and gives back gives more than it was given.
LineChart run_slow_presses(const Run& run) {
    constexpr double kMilli = 1.0e3;
    LineChart chart = make_link_chart("slow-presses", "Net energy to the hand after slow presses");
    chart.work =
        "A fingertip of 300 N/m on the same arm wants to be up to 10 mm inside a wall and out "
        "again, 3 s each time, all through haptic loop, link and arm's server; the work that was "
        "done on it, less what it did.";
    chart.reference = "a wall of springs alone gives nothing: 0";
    chart.y = {"net energy to the hand", "mJ", false};
    chart.advice =
        "What is lent to bring the picture of a hand back is a power, not an energy: it adds up as "
        "long as the hand presses.";
    struct Case {
        double stiffness_N_per_m;
        int presses;
    };
    std::vector<Case> cases{{500.0, 1}, {500.0, 3}};
    if (!run.quick()) {
        cases.insert(cases.end(), {{500.0, 10}, {1000.0, 10}});
    }
    for (const Case& tried : cases) {
        chart.trace(to_text(tried.stiffness_N_per_m) + " N/m, " + std::to_string(tried.presses) +
                        (tried.presses == 1 ? " press" : " presses"),
                    LineStyle::measured,
                    run.pick<std::vector<double>>({0.0, 10.0, 20.0, 50.0, 95.0}, {0.0, 50.0}),
                    [&](double delay_ms) {
                        LinkTrial trial = make_link_trial(1e-3 * delay_ms, kFingertip);
                        trial.stiffness_N_per_m = tried.stiffness_N_per_m;
                        const LinkCourse course =
                            run_link_trial(with_slow_presses(trial, tried.presses));
                        return course.linked ? kMilli * course.net_J : kNone;
                    });
    }
    return chart;
}

Report run_link_stability(Run& run) {
    const std::vector<LossKind> losses{
        {"no loss", 0.0, 1}, {"5 % in bursts of 10", 0.05, 10}, {"20 % one by one", 0.2, 1}};
    LineChart fingertip = run_stiffest(run, "fingertip", kFingertip, losses);
    run.progress(0.5, "another hand");
    LineChart arm = run_stiffest(run, "arm", kArm, losses);
    run.progress(0.95, "force");
    return {std::move(fingertip), std::move(arm), run_force(run), run_slow_presses(run)};
}

const Registration kLinkStability{
    {"link-stability", "how stiff a wall may be over the arm link, against delay and loss",
     run_link_stability}};

}  // namespace
}  // namespace fulcrum::bench
