// What is seen of a force by a hand that yields to it, and what that takes of the force and of time: haptics/device/mouse/pointer_device.h.
#include "haptics/surface/materials.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/pointed_touch.h"
#include "tests/support/sent_force.h"

namespace fulcrum::bench {
namespace {

constexpr double kBall_m = 0.1;
constexpr double kDepth_m = 0.004;

// What is sent where the pointer is so deep in a ball of that stiffness, beside what a hand that is there meets.
double find_force_kept(double yield, double stiffness_N_per_m) {
    Material material = *find_material("metal");
    material.friction = {};
    material.texture = {};
    material.transient = {};
    material.coupling = {.stiffness_N_per_m = stiffness_N_per_m, .damping_Ns_per_m = 0.0};
    test::PointedTouch mouse(test::make_touch_lesson(material, false, "sphere"), nullptr, yield);
    (void)mouse.point_at({0.0, kBall_m + 0.02, 0.0}, 1.0);
    const double sent_N = mouse.point_at({0.0, kBall_m - kDepth_m, 0.0}, 1.5).norm();
    return sent_N / (stiffness_N_per_m * kDepth_m);
}

// Until nine tenths of a leap of the pointer are made while that pushes, seconds.
double find_lateness_s(double yield, double force_N) {
    constexpr double kLeap_m = 0.1;
    LatestValue<PointerTarget> target;
    PointerDevice mouse(make_yielding(yield), target);
    DeviceReading reading;
    double now_s = 0.0;
    const auto step = [&] {
        now_s += 1e-3;
        (void)mouse.read(now_s, reading);
        (void)mouse.write(now_s, {Vector3(0.0, -force_N, 0.0), Vector3::Zero()});
        return reading.pose_D.position.x();
    };
    target.publish({});
    for (int i = 0; i < 2000; ++i) {
        (void)step();
    }
    target.publish({Vector3(kLeap_m, 0.0, 0.0), 0});
    const double began_s = now_s;
    while (step() < 0.9 * kLeap_m) {
    }
    return now_s - began_s;
}

Report run_yielding_mouse(Run& run) {
    const double finest = run.pick(0.1, 0.5);
    std::vector<double> yields;
    for (double yield = 0.0; yield <= kMostYield + 1e-9; yield += finest) {
        yields.push_back(yield);
    }
    LineChart force;
    force.name = "yielding-mouse-force";
    force.title = "What is left of a force where the hand on the screen gives way";
    force.work =
        "A mouse 4 mm inside a ball of that stiffness, plan and gate of a lesson: what is sent "
        "and drawn, of what a hand meets that stays there. It hangs 4 mm lower for each newton "
        "at 1.";
    force.reference = "dashed: two springs in line, 1 / (1 + sag times stiffness)";
    force.advice =
        "Leave it at 1; take 0 to press as hard as an arm does, 2 where small weights should be "
        "told apart by eye.";
    force.x = {"how strongly it yields, --yield", "", false};
    force.y = {"force that is left", "", false};
    for (const double stiffness_N_per_m : {100.0, 300.0, 1000.0}) {
        run.progress(stiffness_N_per_m / 2000.0, "force");
        const std::string name = to_text(stiffness_N_per_m) + " N/m";
        force.trace(name, LineStyle::measured, yields,
                    [&](double yield) { return find_force_kept(yield, stiffness_N_per_m); });
        force.trace(name + ", springs in line", LineStyle::theory, yields, [&](double yield) {
            return 1.0 / (1.0 + make_yielding(yield).sag_m_per_N * stiffness_N_per_m);
        });
    }
    LineChart time;
    time.name = "yielding-mouse-lateness";
    time.title = "How late a loaded hand on the screen comes";
    time.work = "The mouse leaps 10 cm while that weighs on it: until nine tenths are made.";
    time.advice = force.advice;
    time.x = force.x;
    time.y = {"lateness", "s", false};
    for (const double force_N : {0.0, 1.0, 3.0, 5.0}) {
        time.trace(to_text(force_N) + " N", LineStyle::measured, yields,
                   [&](double yield) { return find_lateness_s(yield, force_N); });
    }
    return {force, time};
}

const Registration kYieldingMouse{
    {"yielding-mouse", "what a mouse's hand that gives way shows of a force, and what it costs",
     run_yielding_mouse}};

}  // namespace
}  // namespace fulcrum::bench
