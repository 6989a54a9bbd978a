// What each limit of the last gate costs and what it gives, over the limit; all else as it ships. Hands on the desktop arm, without its
// dry friction, press a wall that a lesson declares, or rest in a force that is there from the start.
#include "tests/bench/harness/curve.h"
#include "tests/support/declared_wall.h"

namespace fulcrum::bench {
namespace {

struct TriedHand {
    const char* name;
    HumanImpedance human;
};
constexpr TriedHand kHands[] = {
    {"fingertip of 5 N", kFingertip}, {"arm", kArm}, {"hand that keeps its posture", kPosture}};

// The most that is asked for, of what the arm has, and not sent while the wall is pressed, for half a second from where the hand sets out.
double find_withheld_N(const HumanImpedance& human, double slew_N_per_s, bool has_transients) {
    test::DeclaredWall wall{.stiffness_N_per_m = 1000.0, .human = human};
    wall.change = [&](HapticPlan& plan) {
        plan.safety.max_slew_N_per_s = slew_N_per_s;
        plan.safety.max_transient_N = has_transients ? plan.safety.max_transient_N : 0.0;
    };
    test::DeclaredWallRig rig(wall);
    rig.press();
    double most_N = 0.0;
    for (int n = 0; n < 500; ++n) {
        rig.step();
        const HapticState& state = rig.state();
        const double asked_N =
            std::min(state.commanded_W.force.norm(), rig.arm().traits().max_force_N);
        most_N = std::max(most_N, asked_N - state.applied_W.force.norm());
    }
    return most_N;
}

LineChart draw_slew(const Run& run) {
    LineChart chart;
    chart.name = "gate-limits-slew";
    chart.title = "What the gate keeps back when a wall is met, over its slew";
    chart.work =
        "Hands come down 10 mm by their own spring and press 4 mm into a wall of 1000 N/m and 9.5 "
        "Ns/m.";
    chart.reference = "the same gate without transients: the slew alone";
    chart.advice = "As it ships, 500 N/s: what is short passes as a transient all the same.";
    chart.x = {"slew", "N/s", true};
    chart.y = {"most that is asked for and not sent", "N", false};
    const auto slews_N_per_s =
        run.pick<std::vector<double>>({50, 100, 200, 300, 500, 1000, 2000, 5000}, {100, 500});
    for (const TriedHand& hand : kHands) {
        for (const bool has_transients : {true, false}) {
            chart.trace(hand.name + std::string(has_transients ? "" : ", slew alone"),
                        has_transients ? LineStyle::measured : LineStyle::theory, slews_N_per_s,
                        [&](double slew_N_per_s) {
                            return find_withheld_N(hand.human, slew_N_per_s, has_transients);
                        });
        }
    }
    return chart;
}

// A hand that rests where a spring of 100 N/m pulls it by 20 mm, from the start.
struct SoftStart {
    double speed_m_per_s = 0.0;  // most
    double waits_s = 0.0;        // until nine tenths of what the spring then pulls are sent
};
SoftStart start_softly(const HumanImpedance& human, double soft_start_N_per_s) {
    test::DeclaredWall wall{
        .stiffness_N_per_m = 100.0, .damping_Ns_per_m = 2.0, .human = human, .is_spring = true};
    wall.change = [&](HapticPlan& plan) { plan.safety.soft_start_N_per_s = soft_start_N_per_s; };
    test::DeclaredWallRig rig(wall, 0.02);
    SoftStart start;
    const double dt_s = 1.0 / wall.rate_Hz;
    double before_m = rig.height_m();
    for (double s = 0.0; s < 3.0; s += dt_s) {
        rig.step();
        const double height_m = rig.height_m();
        start.speed_m_per_s =
            std::max(start.speed_m_per_s, std::abs(height_m - before_m) * wall.rate_Hz);
        before_m = height_m;
        if (start.waits_s == 0.0 && rig.sent_N() > 0.9 * rig.state().commanded_W.force.y() &&
            rig.sent_N() > 0.1) {
            start.waits_s = s;
        }
    }
    return start;
}

void add_soft_start(const Run& run, Report& report) {
    LineChart chart;
    chart.name = "gate-limits-soft-start";
    chart.title = "How a force that is there from the start comes in, over the soft start";
    chart.work = "Hands rest 20 mm from where a spring of 100 N/m pulls them to, from the start.";
    chart.advice = "As it ships, 5 N/s: nobody is pushed faster than he can follow.";
    chart.x = {"soft start", "N/s", true};
    const auto rises_N_per_s =
        run.pick<std::vector<double>>({1, 2, 5, 10, 20, 50, 100, 200}, {2, 20});
    LineChart waits = chart;
    waits.name = "gate-limits-soft-start-waits";
    chart.y = {"fastest of the hand", "mm/s", false};
    waits.y = {"until nine tenths of it are felt", "s", false};
    for (const TriedHand& hand : kHands) {
        Line speed{hand.name};
        Line wait{hand.name};
        for (const double rise_N_per_s : rises_N_per_s) {
            const SoftStart start = start_softly(hand.human, rise_N_per_s);
            speed.add(rise_N_per_s, 1.0e3 * start.speed_m_per_s);
            wait.add(rise_N_per_s, start.waits_s);
        }
        chart.lines.push_back(speed);
        waits.lines.push_back(wait);
    }
    report.emplace_back(chart);
    report.emplace_back(waits);
}

LineChart draw_saturation(const Run& run) {
    LineChart chart;
    chart.name = "gate-limits-saturation";
    chart.title = "How soft a wall becomes where the limit of force cuts it";
    chart.work =
        "A hand of 300 N/m that keeps its posture wants to be 10 mm inside walls: how deep it "
        "comes once it rests. The desktop arm's motors have 3.3 N.";
    chart.reference = "the wall and the hand as two springs";
    chart.advice =
        "As it ships, 5 N: a scene should ask for less, for beyond it every wall is as soft as "
        "the hand.";
    chart.x = {"limit of force", "N", true};
    chart.y = {"depth", "mm", true};
    const auto limits_N = run.pick<std::vector<double>>({0.5, 0.7, 1, 1.4, 2, 3, 5, 10}, {1, 5});
    for (const double stiffness_N_per_m : {300.0, 1000.0, 3000.0}) {
        const std::string name = to_text(stiffness_N_per_m) + " N/m";
        constexpr double kWanted_m = 0.01;
        chart.trace(name, LineStyle::measured, limits_N, [&](double limit_N) {
            test::DeclaredWall wall{
                .stiffness_N_per_m = stiffness_N_per_m, .human = kPosture, .press_m = kWanted_m};
            wall.change = [&](HapticPlan& plan) { plan.safety.max_force_N = limit_N; };
            test::DeclaredWallRig rig(wall);
            rig.press();
            rig.run(3.0);
            return 1.0e3 * rig.run_window().depth_m;
        });
        const double depth_m = kPosture.stiffness_N_per_m * kWanted_m /
                               (stiffness_N_per_m + kPosture.stiffness_N_per_m);
        chart.trace(name + ", no limit", LineStyle::theory, limits_N,
                    [&](double) { return 1.0e3 * depth_m; });
    }
    return chart;
}

Report run_gate_limits(Run& run) {
    Report report;
    run.progress(0.0, "slew");
    report.emplace_back(draw_slew(run));
    run.progress(0.5, "soft start");
    add_soft_start(run, report);
    run.progress(0.8, "saturation");
    report.emplace_back(draw_saturation(run));
    return report;
}

// A wall that no plan would hold, undamped: the passivity stage alone keeps it at rest.
test::DeclaredWallCourse press_undamped(double stiffness_N_per_m,
                                        const std::function<void(PassivitySettings&)>& set) {
    test::DeclaredWall wall;
    wall.change = [&](HapticPlan& plan) {
        plan.solids.front().coupling->stiffness_N_per_m = stiffness_N_per_m;
        plan.solids.front().coupling->damping_Ns_per_m = 0.0;
        set(plan.passivity);
    };
    return test::press_declared_wall(wall);
}

void add_passivity(const Run& run, Report& report, const std::string& name, const Axis& x,
                   const std::vector<double>& values, const std::string& advice,
                   const std::function<void(PassivitySettings&, double)>& set) {
    LineChart counted;
    counted.name = name;
    counted.title = "Energy beyond what an undamped wall gives, over the brake's " + x.name;
    counted.work =
        "A fingertip on the desktop arm presses walls of no damping by 4 mm, at 1 kHz, with the "
        "gate as it ships.";
    counted.advice = advice;
    counted.x = x;
    counted.y = {"most at a time, as the passivity stage counts it", "mJ", false};
    LineChart given = counted;
    given.name = name + "-given";
    given.title = "Energy that an undamped wall gives the hand, over the brake's " + x.name;
    given.y = {"given and not taken back, most of all times", "mJ", false};
    for (const double stiffness_N_per_m :
         run.pick<std::vector<double>>({500.0, 1000.0, 2000.0, 4000.0}, {2000.0})) {
        Line excess{to_text(stiffness_N_per_m) + " N/m"};
        Line all = excess;
        for (const double value : values) {
            const test::DeclaredWallCourse course = press_undamped(
                stiffness_N_per_m, [&](PassivitySettings& settings) { set(settings, value); });
            excess.add(value, 1.0e3 * course.excess_J);
            all.add(value, 1.0e3 * course.given_J);
        }
        counted.lines.push_back(excess);
        given.lines.push_back(all);
    }
    report.emplace_back(counted);
    report.emplace_back(given);
}

Report run_passivity_budget(Run& run) {
    Report report;
    run.progress(0.0, "headroom");
    add_passivity(
        run, report, "passivity-budget-headroom", {"headroom", "J", true},
        run.pick<std::vector<double>>({1e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 1e-2}, {1e-5, 1e-4}),
        "As it ships, 0.1 mJ: with more a wall buzzes before it is braked.",
        [](PassivitySettings& settings, double headroom_J) { settings.headroom_J = headroom_J; });
    run.progress(0.5, "memory");
    add_passivity(
        run, report, "passivity-budget-memory", {"memory", "s", true},
        run.pick<std::vector<double>>({0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0}, {0.1, 1.0}),
        "As it ships, 0.1 s: what dampers earned long ago licenses no buzz.",
        [](PassivitySettings& settings, double memory_s) { settings.memory_s = memory_s; });
    return report;
}

const Registration kGateLimits{{"gate-limits",
                                "what the gate's slew, soft start and limit of force cost and give",
                                run_gate_limits}};
const Registration kPassivityBudget{{"passivity-budget",
                                     "what the passivity stage's headroom and memory cost and give",
                                     run_passivity_budget}};

}  // namespace
}  // namespace fulcrum::bench
