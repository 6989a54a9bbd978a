#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/loop/device_faults.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <memory>

using namespace fulcrum;

namespace {

HapticPlan make_damped_plan(double damping_Ns_per_m) {
    HapticPlan plan;
    plan.fields = {FieldPlan{FieldKind::viscosity, Vector3::Zero(), 0.0, damping_Ns_per_m}};
    return plan;
}
HapticPlan make_lonely_plan() {
    HapticPlan plan;
    plan.expects_lesson = false;
    return plan;
}

// The hand goes along x at such a speed, for so many rounds.
void go(Bench& bench, double speed_m_per_s, int n) {
    for (int k = 0; k < n; ++k) {
        bench.move(speed_m_per_s * kDt_s);
    }
}

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

// What fades the force, and what the loop lets nobody talk it out of.

TEST_CASE("haptic loop: a device that gives no pose, an old one or a broken one fades the force") {
    for (const DeviceFault& fault : kDeviceFaults) {
        CAPTURE(fault.name);
        HoldingBench bench;
        fault.spoil(bench.device);
        bench.run(1);
        CHECK(bench.saw(fault.told));
        CHECK(bench.state().gate == GatePhase::fading);
        CHECK(is_finite(bench.state().tool_pose_W));
        CHECK(bench.state().tool_twist_W.linear.norm() == 0.0);
        bench.run(100);
        CHECK(bench.written_N().norm() == 0.0);
    }
    // A pose in time is none of that.
    Bench bench(make_weight_plan());
    bench.device.age_s = 0.019;
    hold(bench);
    CHECK(bench.state().faults == Fault::none);
    // A wrench that is refused is told from the next round on.
    bench.device.takes_wrench = false;
    bench.run(1);
    CHECK(bench.state().gate == GatePhase::open);
    bench.run(1);
    CHECK(bench.saw(Fault::device_write));
    CHECK(bench.state().gate == GatePhase::fading);
}

TEST_CASE("haptic loop: no force before the first pose; a stamp that goes back begins anew") {
    HapticPlan plan = make_lonely_plan();
    plan.fields = {FieldPlan{FieldKind::spring, Vector3(0.0, 1.0, 0.0), 1000.0}};
    Bench bench(plan);
    bench.command.fields[0].anchor_W = Vector3(0.0, 1.0, 0.0);
    bench.device.gives_pose = false;
    bench.run(100);
    CHECK(bench.state().commanded_W.force.norm() == 0.0);
    CHECK(bench.saw(Fault::device_read));
    Bench other{HapticPlan{}};
    go(other, 0.3, 100);
    other.device.age_s = 0.010;
    other.run(1);
    CHECK(other.saw(Fault::device_invalid));
    CHECK(other.state().tool_twist_W.linear.norm() == 0.0);
    go(other, -0.2, 100);
    CHECK(other.state().faults == Fault::none);
    CHECK(other.state().tool_twist_W.linear.x() == Approx(-0.2));
}

TEST_CASE("haptic loop: one pose stamped in the future costs no damping afterwards") {
    for (const double ahead_s : {60.0, 0.019, 0.0011}) {
        Bench bench(make_damped_plan(10.0));
        go(bench, 0.3, 500);
        CHECK(bench.state().commanded_W.force.x() == Approx(-3.0).epsilon(1e-6));
        bench.device.age_s = -ahead_s;
        go(bench, 0.3, 1);
        CHECK(bench.saw(Fault::device_stale));
        bench.device.age_s = 0.0;
        go(bench, 0.3, 100);
        CHECK(bench.state().faults == Fault::none);
        CHECK(bench.state().commanded_W.force.x() == Approx(-3.0).epsilon(1e-6));
    }
    // Up to a period ahead is a device's clock being read a moment later.
    Bench bench{HapticPlan{}};
    bench.device.age_s = -0.0009;
    bench.run(100);
    CHECK(bench.state().faults == Fault::none);
}

TEST_CASE("haptic loop: a command or a world is stale from a second ahead, or if never heard of") {
    for (const bool from_lesson : {true, false}) {
        CAPTURE(from_lesson);
        Bench bench(make_weight_plan());
        bench.run(10);
        REQUIRE(bench.state().faults == Fault::none);
        (from_lesson ? bench.lesson_awake : bench.world_awake) = false;
        (from_lesson ? bench.command.stamp_s : bench.world.stamp_s) = bench.now_s + 1.0;
        bench.channels->command.publish(bench.command);
        bench.channels->world.publish(bench.world);
        bench.run(1);
        CHECK(bench.saw(Fault::command_stale));
        Bench unheard(make_weight_plan());
        (from_lesson ? unheard.lesson_awake : unheard.world_awake) = false;
        unheard.run(1);
        CHECK(unheard.saw(Fault::command_stale));
    }
    // After a tenth of a second, not before.
    Bench bench(make_weight_plan());
    bench.run(100);
    bench.loop.step(bench.now_s + 0.0995);
    CHECK(bench.state().faults == Fault::none);
    bench.loop.step(bench.now_s + 0.1005);
    CHECK(bench.saw(Fault::command_stale));
    // Nor where the plan waits for neither.
    Bench lonely(make_lonely_plan());
    lonely.lesson_awake = lonely.world_awake = false;
    lonely.run(100);
    CHECK(lonely.state().faults == Fault::none);
}

TEST_CASE("haptic loop: which orientations are one, and how fast the fastest hand is") {
    Bench bench{HapticPlan{}};
    bench.device.pose_D.orientation.coeffs() *= 1.0009;
    bench.run(1);
    CHECK(bench.state().faults == Fault::none);
    CHECK(bench.state().tool_pose_W.orientation.coeffs().norm() == Approx(1.0).epsilon(1e-12));
    bench.device.pose_D.orientation.coeffs() *= 1.002;
    bench.run(1);
    CHECK(bench.saw(Fault::device_invalid));
    for (const double speed_m_per_s : {9.9, 10.1}) {
        for (const bool repeats_stamp : {false, true}) {
            HapticPlan plan = make_lonely_plan();
            plan.rate_hz = 5000.0;
            Bench fast(plan);
            fast.loop.step(1.0);
            // A reading without a new stamp may have come a period later.
            fast.device.pose_D.position.x() = speed_m_per_s * 0.0002;
            constexpr double kPeriod_s = 1.0 / 8192.0;  // sums of it are exact
            fast.device.age_s = repeats_stamp ? kPeriod_s : 0.0;
            fast.loop.step(1.0 + kPeriod_s);
            CHECK(fast.saw(Fault::device_invalid) == (speed_m_per_s > 10.0));
        }
    }
}

TEST_CASE("haptic loop: a clock that stands still or is no number is a fault") {
    for (const bool stopped : {false, true}) {
        HoldingBench bench;
        if (stopped) {
            bench.channels->emergency_stop.press();
        }
        for (int k = 0; k < 100; ++k) {
            bench.loop.step(bench.now_s);
            REQUIRE(bench.saw(Fault::command_invalid));
        }
        CHECK(bench.written_N().norm() == 0.0);
    }
    Bench bench(make_weight_plan());
    for (const double now_s : {kNan, kInfinity}) {
        const double before_s = bench.now_s;
        bench.loop.step(now_s);
        CHECK(bench.saw(Fault::command_invalid));
        CHECK(bench.state().time_s == before_s);
        bench.run(2);
        CHECK(bench.state().faults == Fault::none);
    }
    // Nor does time that runs back, or is none, give a force that time would not.
    for (const double ahead_s : {-0.5, kNan}) {
        HoldingBench held;
        held.loop.step(held.now_s + ahead_s);
        CHECK(held.written_N().norm() == 0.0);
    }
}

TEST_CASE("haptic loop: a silent lesson, a dead one, one that is over, a silent world: all fade") {
    struct Silence {
        void (*begin)(Bench& bench);
        Fault told;
        bool is_late;  // noticed after a tenth of a second
    };
    for (const Silence& silence :
         {Silence{[](Bench& b) { b.lesson_awake = false; }, Fault::command_stale, true},
          Silence{[](Bench& b) { b.world_awake = false; }, Fault::command_stale, true},
          Silence{[](Bench& b) { b.command.lesson_alive = false; }, Fault::lesson_failed, false},
          Silence{[](Bench& b) { b.channels->lesson_failed.store(true); }, Fault::lesson_failed,
                  false},
          Silence{[](Bench& b) { b.channels->ended.store(true); }, Fault::ended, false},
          Silence{[](Bench& b) { b.world.carried_force_W.x() = kInfinity; }, Fault::command_invalid,
                  false}}) {
        HoldingBench bench;
        silence.begin(bench);
        bench.run(99);
        if (silence.is_late) {
            CHECK(bench.state().gate == GatePhase::open);
            bench.run(2);
        }
        CAPTURE(static_cast<std::uint32_t>(silence.told));
        CHECK(bench.saw(silence.told));
        CHECK(bench.saw(Fault::lesson_failed) == (silence.told == Fault::lesson_failed));
        CHECK(bench.state().gate != GatePhase::open);
        bench.run(101);
        CHECK(bench.written_N().norm() == 0.0);
        // It comes back, softly, when all is well again and the hand is empty.
        bench.lesson_awake = bench.world_awake = bench.command.lesson_alive = true;
        bench.channels->lesson_failed.store(false);
        bench.channels->ended.store(false);
        bench.world.carried_force_W.setZero();
        bench.run(1000);
        CHECK(bench.state().faults == Fault::none);
        CHECK(bench.state().gate == GatePhase::rising);
    }
}

TEST_CASE("haptic loop: silence writes zero and the force must engage again") {
    HoldingBench bench;
    bench.loop.silence(bench.now_s);
    CHECK(bench.written_N().norm() == 0.0);
    bench.run(10);
    CHECK(bench.written_N().norm() == 0.0);
    CHECK(bench.state().gate == GatePhase::waiting);
}

TEST_CASE("haptic loop: a full recorder is a fault, an emptied one is none") {
    auto ring = std::make_unique<RecordRing>();
    Bench bench(make_weight_plan(), {.record = ring.get()});
    bench.run(static_cast<int>(kRecordRingCapacity));
    CHECK(bench.state().faults == Fault::none);
    bench.run(2);
    CHECK(bench.saw(Fault::record_full));
    RecordRound round;
    REQUIRE(ring->pop(round));
    CHECK(round.sample.tick == 0);
    CHECK(round.sample.time_s == kDt_s);
    while (ring->pop(round)) {
    }
    CHECK(round.sample.tick == kRecordRingCapacity - 1);
    bench.run(2);
    CHECK(bench.state().faults == Fault::none);
}

TEST_CASE("haptic loop: a hand that is too fast feels nothing, and the force comes back softly") {
    HoldingBench bench;
    go(bench, 4.0, 125);  // and 3 m/s may be
    go(bench, -4.0, 125);
    CHECK(bench.written_N().norm() == 0.0);
    CHECK(bench.state().gate == GatePhase::waiting);
    bench.world.carried_force_W.setZero();
    bench.run(300);
    bench.world.carried_force_W.y() = -3.0;
    bench.run(200);
    CHECK(bench.written_N().norm() > 0.5);
    CHECK(bench.written_N().norm() < 1.1);  // 5 N/s
}

TEST_CASE("haptic loop: energy given beyond what may be fades the force") {
    // With 3 N along 2 m/s the hand is given 6 W; 5 J may be given in about a second.
    HapticPlan plan = make_weight_plan();
    plan.safety.max_energy_J = 2.0;
    HoldingBench bench(plan);
    double given_J = 0.0;
    bool is_told = false;
    for (int i = 0; i < 600; ++i) {
        const double way_m = -2.0 * kDt_s;
        given_J += bench.written_N().y() * way_m;
        bench.move(0.0, way_m);
        is_told = is_told || bench.saw(Fault::too_much_energy);
    }
    CHECK(is_told);
    CHECK(bench.written_N().norm() == 0.0);
    // What is forgotten meanwhile, and what the fade still gives.
    CHECK(given_J < 3.2);
    CHECK(given_J > 2.0);
}

// The emergency stop: how it is pressed, how it fades, and what alone lifts it.

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

TEST_CASE("haptic loop: a rearm takes no force away, and undoes no stop that comes after it") {
    StoppedBench bench;
    bench.rearm();
    CHECK(bench.run_to_gate(1) == GatePhase::open);
    CHECK_FALSE(bench.channels->rearm.load());
    CHECK(bench.written_N().y() == Approx(-3.0));
    StoppedBench other;
    other.channels->emergency_stop.tap();
    other.run(5);
    other.rearm();  // waits until the fade is over
    other.run(5);
    REQUIRE(other.written_N().norm() > 0.0);
    other.channels->emergency_stop.tap();
    other.world.carried_force_W.setZero();
    CHECK(other.run_to_gate(1000) == GatePhase::stopped);
    other.rearm();
    CHECK(other.run_to_gate(10) != GatePhase::stopped);
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
