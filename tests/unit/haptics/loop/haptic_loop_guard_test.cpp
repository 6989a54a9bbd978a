// What the loop lets nobody talk it out of: its guard's limits of speed and energy, and a stop.
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

using namespace fulcrum;

TEST_CASE(
    "haptic loop: a hand that is faster than may be felt feels nothing, and the force comes back "
    "softly") {
    Bench bench(make_weight_plan());
    hold(bench);
    const double fast_m = 4.0 * kDt_s;  // 4 m/s, and 3 may be
    for (int i = 0; i < 250; ++i) {
        bench.device.pose_D.position.x() += i < 125 ? fast_m : -fast_m;
        bench.run(1);
    }
    CHECK(bench.device.written_D.force.norm() == 0.0);
    CHECK(bench.loop.state().gate == GatePhase::waiting);
    bench.world.carried_force_W.setZero();
    bench.run(300);
    bench.world.carried_force_W.y() = -3.0;
    bench.run(200);
    CHECK(bench.device.written_D.force.norm() > 0.5);
    CHECK(bench.device.written_D.force.norm() < 1.1);  // 5 N/s
}

TEST_CASE("haptic loop: energy given beyond what may be fades the force") {
    // With 3 N along 2 m/s the hand is given 6 W; 5 J may be given in about a second.
    HapticPlan plan = make_weight_plan();
    plan.safety.max_energy_J = 2.0;
    Bench bench(plan);
    hold(bench);
    double given_J = 0.0;
    bool is_told = false;
    for (int i = 0; i < 600; ++i) {
        const double way_m = -2.0 * kDt_s;
        given_J += bench.device.written_D.force.y() * way_m;
        bench.device.pose_D.position.y() += way_m;
        bench.run(1);
        is_told = is_told || saw(bench, Fault::too_much_energy);
    }
    CHECK(is_told);
    CHECK(bench.device.written_D.force.norm() == 0.0);
    // What is forgotten meanwhile, and what the fade still gives.
    CHECK(given_J < 3.2);
    CHECK(given_J > 2.0);
}

TEST_CASE(
    "haptic loop: a stop that is pressed and lifted between two rounds fades, and is lifted then") {
    Bench bench(make_weight_plan());
    hold(bench);
    bench.channels->emergency_stop.press();
    bench.channels->emergency_stop.release();
    bench.channels->rearm.store(true);
    bench.run(1);
    CHECK(bench.loop.state().gate == GatePhase::stopped);
    bench.run(90);
    CHECK(bench.loop.state().gate == GatePhase::stopped);
    bench.run(20);
    CHECK(bench.device.written_D.force.norm() == 0.0);
    CHECK(bench.loop.state().gate != GatePhase::stopped);
    CHECK_FALSE(bench.channels->rearm.load());
}
