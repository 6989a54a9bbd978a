// The emergency stop: how it is pressed, how it fades, and what alone lifts it.
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

// Holding 3 N, with a hand on the switch.
struct StoppedBench : HoldingBench {
    void press() { channels->emergency_stop.press(); }
    void release() { channels->emergency_stop.release(); }
    void rearm() { channels->rearm.store(true); }
    GatePhase run_to_gate(int n) {
        run(n);
        return state().gate;
    }
};

}  // namespace

TEST_CASE("haptic loop: the emergency stop latches until it is lifted and rearmed") {
    StoppedBench bench;
    bench.press();
    CHECK(bench.run_to_gate(1) == GatePhase::stopped);
    bench.run(100);
    CHECK(bench.written_N().norm() == 0.0);
    bench.rearm();
    CHECK(bench.run_to_gate(10) == GatePhase::stopped);
    bench.channels->rearm.store(false);
    bench.release();
    CHECK(bench.run_to_gate(1000) == GatePhase::stopped);
    // Silence does not lift it.
    bench.loop.silence(bench.now_s);
    CHECK(bench.run_to_gate(10) == GatePhase::stopped);
    bench.rearm();
    bench.world.carried_force_W.setZero();
    CHECK(bench.run_to_gate(400) == GatePhase::rising);
    CHECK_FALSE(bench.channels->rearm.load());
}

TEST_CASE("haptic loop: a stop that is pressed and released within one round still stops") {
    StoppedBench bench;
    bench.press();
    bench.release();
    CHECK(bench.run_to_gate(1) == GatePhase::stopped);
    CHECK(bench.saw(Fault::emergency_stop));
    CHECK(bench.run_to_gate(200) == GatePhase::stopped);
    CHECK(bench.written_N().norm() == 0.0);
    // It was one press, and its end is a rearm.
    CHECK(bench.state().faults == Fault::none);
    bench.rearm();
    CHECK(bench.run_to_gate(1) == GatePhase::waiting);
    // Lifted between the same two rounds it fades, and is lifted then.
    StoppedBench lifted;
    lifted.press();
    lifted.release();
    lifted.rearm();
    CHECK(lifted.run_to_gate(1) == GatePhase::stopped);
    CHECK(lifted.run_to_gate(90) == GatePhase::stopped);
    CHECK(lifted.run_to_gate(20) != GatePhase::stopped);
    CHECK(lifted.written_N().norm() == 0.0);
    CHECK_FALSE(lifted.channels->rearm.load());
}

TEST_CASE("haptic loop: a rearm where nothing was stopped takes no force away") {
    StoppedBench bench;
    bench.rearm();
    CHECK(bench.run_to_gate(1) == GatePhase::open);
    CHECK_FALSE(bench.channels->rearm.load());
    CHECK(bench.written_N().y() == Approx(-3.0));
}

TEST_CASE("haptic loop: a stop that comes while an earlier one is being lifted stays") {
    StoppedBench bench;
    bench.channels->emergency_stop.tap();
    bench.run(5);
    bench.rearm();  // waits until the fade is over
    bench.run(5);
    REQUIRE(bench.written_N().norm() > 0.0);
    bench.channels->emergency_stop.tap();
    bench.world.carried_force_W.setZero();
    CHECK(bench.run_to_gate(1000) == GatePhase::stopped);
    bench.rearm();
    CHECK(bench.run_to_gate(10) != GatePhase::stopped);
}

TEST_CASE("haptic loop: a stop lifted in the middle of its fade still fades to its end") {
    StoppedBench bench;
    const double held_N = bench.written_N().norm();
    bench.press();
    bench.run(20);
    bench.release();
    bench.rearm();
    double before_N = bench.written_N().norm();
    REQUIRE(before_N > 0.5 * held_N);
    for (int k = 0; k < 100; ++k) {
        bench.run(1);
        const double now_N = bench.written_N().norm();
        REQUIRE(before_N - now_N <= 1.01 * held_N * 0.001 / 0.1);
        REQUIRE(now_N <= before_N + 1e-12);
        before_N = now_N;
    }
    CHECK(before_N == 0.0);
}
