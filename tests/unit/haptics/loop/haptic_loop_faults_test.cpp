#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <limits>
#include <memory>

using namespace fulcrum;

TEST_CASE("haptic loop: a device that gives no pose, an old one or a broken one fades the force") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int kind = 0; kind < 5; ++kind) {
        Bench bench(make_weight_plan());
        hold(bench);
        Fault expected = Fault::device_invalid;
        switch (kind) {
            case 0:
                bench.device.gives_pose = false;
                expected = Fault::device_read;
                break;
            case 1:
                bench.device.age_s = 0.021;
                expected = Fault::device_stale;
                break;
            case 2:
                bench.device.pose_D.position.y() = nan;
                break;
            case 3:
                bench.device.pose_D.orientation.coeffs().setZero();
                break;
            default:
                bench.device.pose_D.position.y() = 0.011;  // 11 m/s
        }
        bench.run(1);
        CHECK(saw(bench, expected));
        CHECK(bench.loop.state().gate == GatePhase::fading);
        CHECK(is_finite(bench.loop.state().tool_pose_W));
        CHECK(bench.loop.state().tool_twist_W.linear.norm() == 0.0);
        bench.run(100);
        CHECK(bench.device.written_D.force.norm() == 0.0);
    }
    // A pose in time is none of that.
    Bench bench(make_weight_plan());
    bench.device.age_s = 0.019;
    hold(bench);
    CHECK(bench.loop.state().faults == Fault::none);
}

TEST_CASE("haptic loop: before the first pose there is no force and no proxy at the origin") {
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3(0.0, 1.0, 0.0), 1000.0}};
    Bench bench(plan);
    bench.command.fields[0].anchor_W = Vector3(0.0, 1.0, 0.0);
    bench.device.gives_pose = false;
    bench.run(100);
    CHECK(bench.loop.state().commanded_W.force.norm() == 0.0);
    CHECK(saw(bench, Fault::device_read));
}

TEST_CASE("haptic loop: one pose stamped in the future costs no damping afterwards") {
    for (const double ahead_s : {60.0, 0.019, 0.0011}) {
        HapticPlan plan;
        plan.fields = {FieldPlan{FieldKind::viscosity, Vector3::Zero(), 0.0, 10.0}};
        Bench bench(plan);
        const auto move = [&](int n) {
            for (int k = 0; k < n; ++k) {
                bench.device.pose_D.position.x() += 0.3 * kDt_s;
                bench.run(1);
            }
        };
        move(500);
        CHECK(bench.loop.state().commanded_W.force.x() == Approx(-3.0).epsilon(1e-6));
        bench.device.age_s = -ahead_s;
        move(1);
        CHECK(saw(bench, Fault::device_stale));
        bench.device.age_s = 0.0;
        move(100);
        CHECK(bench.loop.state().faults == Fault::none);
        CHECK(bench.loop.state().commanded_W.force.x() == Approx(-3.0).epsilon(1e-6));
    }
    // Up to a period ahead is a device's clock being read a moment later.
    Bench bench{HapticPlan{}};
    bench.device.age_s = -0.0009;
    bench.run(100);
    CHECK(bench.loop.state().faults == Fault::none);
}

TEST_CASE("haptic loop: a stamp that goes back is a fault, and motion begins anew") {
    Bench bench{HapticPlan{}};
    for (int k = 0; k < 100; ++k) {
        bench.device.pose_D.position.x() += 0.3 * kDt_s;
        bench.run(1);
    }
    bench.device.age_s = 0.010;
    bench.run(1);
    CHECK(saw(bench, Fault::device_invalid));
    CHECK(bench.loop.state().tool_twist_W.linear.norm() == 0.0);
    for (int k = 0; k < 100; ++k) {
        bench.device.pose_D.position.x() -= 0.2 * kDt_s;
        bench.run(1);
    }
    CHECK(bench.loop.state().faults == Fault::none);
    CHECK(bench.loop.state().tool_twist_W.linear.x() == Approx(-0.2));
}

TEST_CASE(
    "haptic loop: a command or a world from a second ahead is as stale as one from long ago") {
    for (const bool from_lesson : {true, false}) {
        Bench bench(make_weight_plan());
        bench.run(10);
        REQUIRE(bench.loop.state().faults == Fault::none);
        (from_lesson ? bench.lesson_awake : bench.world_awake) = false;
        (from_lesson ? bench.command.stamp_s : bench.world.stamp_s) = bench.now_s + 1.0;
        bench.channels->command.publish(bench.command);
        bench.channels->world.publish(bench.world);
        bench.run(1);
        CHECK(saw(bench, Fault::command_stale));
    }
}

TEST_CASE(
    "haptic loop: a lesson and a world that were never heard are stale from the first round") {
    for (const bool lesson : {true, false}) {
        Bench bench(make_weight_plan());
        bench.lesson_awake = lesson;
        bench.world_awake = !lesson;
        bench.run(1);
        CHECK(saw(bench, Fault::command_stale));
    }
}

TEST_CASE("haptic loop: a command is stale after a tenth of a second, not before") {
    Bench bench(make_weight_plan());
    bench.run(100);
    bench.loop.step(bench.now_s + 0.0995);
    CHECK(bench.loop.state().faults == Fault::none);
    bench.loop.step(bench.now_s + 0.1005);
    CHECK(saw(bench, Fault::command_stale));
}

TEST_CASE("haptic loop: an orientation nearly of length one becomes one, another is a fault") {
    Bench bench{HapticPlan{}};
    bench.device.pose_D.orientation.coeffs() *= 1.0009;
    bench.run(1);
    CHECK(bench.loop.state().faults == Fault::none);
    CHECK(bench.loop.state().tool_pose_W.orientation.coeffs().norm() == Approx(1.0).epsilon(1e-12));
    bench.device.pose_D.orientation.coeffs() *= 1.002;
    bench.run(1);
    CHECK(saw(bench, Fault::device_invalid));
}

TEST_CASE("haptic loop: ten metres a second is the fastest hand, at five kilohertz too") {
    for (const double speed_m_per_s : {9.9, 10.1}) {
        for (const bool repeats_stamp : {false, true}) {
            HapticPlan plan;
            plan.rate_hz = 5000.0;
            plan.expects_lesson = false;
            Bench bench(plan);
            bench.loop.step(1.0);
            // A reading without a new stamp may have come a period later.
            bench.device.pose_D.position.x() = speed_m_per_s * 0.0002;
            constexpr double kPeriod_s = 1.0 / 8192.0;  // sums of it are exact
            bench.device.age_s = repeats_stamp ? kPeriod_s : 0.0;
            bench.loop.step(1.0 + kPeriod_s);
            CHECK(saw(bench, Fault::device_invalid) == (speed_m_per_s > 10.0));
        }
    }
}

TEST_CASE("haptic loop: a stop that is pressed and released within one round still stops") {
    Bench bench(make_weight_plan());
    hold(bench);
    bench.channels->emergency_stop.press();
    bench.channels->emergency_stop.release();
    bench.run(1);
    CHECK(saw(bench, Fault::emergency_stop));
    CHECK(bench.loop.state().gate == GatePhase::stopped);
    bench.run(200);
    CHECK(bench.loop.state().gate == GatePhase::stopped);
    CHECK(bench.device.written_D.force.norm() == 0.0);
    // It was one press, and its end is a rearm.
    CHECK(bench.loop.state().faults == Fault::none);
    bench.channels->rearm.store(true);
    bench.run(1);
    CHECK(bench.loop.state().gate == GatePhase::waiting);
}

TEST_CASE("haptic loop: a rearm where nothing was stopped takes no force away") {
    Bench bench(make_weight_plan());
    hold(bench);
    bench.channels->rearm.store(true);
    bench.run(1);
    CHECK_FALSE(bench.channels->rearm.load());
    CHECK(bench.loop.state().gate == GatePhase::open);
    CHECK(bench.device.written_D.force.y() == Approx(-3.0));
}

TEST_CASE("haptic loop: a clock that stands still is a fault, and the force goes all the same") {
    for (const bool stopped : {false, true}) {
        Bench bench(make_weight_plan());
        hold(bench);
        if (stopped) {
            bench.channels->emergency_stop.press();
        }
        for (int k = 0; k < 100; ++k) {
            bench.loop.step(bench.now_s);
            REQUIRE(saw(bench, Fault::command_invalid));
        }
        CHECK(bench.device.written_D.force.norm() == 0.0);
    }
}

TEST_CASE("haptic loop: a clock that is no number is a fault and is not published") {
    Bench bench(make_weight_plan());
    bench.loop.step(std::numeric_limits<double>::quiet_NaN());
    CHECK(saw(bench, Fault::command_invalid));
    CHECK(bench.loop.state().time_s == 0.0);
    bench.run(2);
    CHECK(bench.loop.state().faults == Fault::none);
    bench.loop.step(std::numeric_limits<double>::infinity());
    CHECK(saw(bench, Fault::command_invalid));
    CHECK(bench.loop.state().time_s == bench.now_s);
    bench.run(1);
    CHECK(bench.loop.state().faults == Fault::none);
}

TEST_CASE("haptic loop: a device that refuses the wrench fades the force from the next round on") {
    Bench bench(make_weight_plan());
    hold(bench);
    bench.device.takes_wrench = false;
    bench.run(1);
    CHECK(bench.loop.state().gate == GatePhase::open);
    bench.run(1);
    CHECK(saw(bench, Fault::device_write));
    CHECK(bench.loop.state().gate == GatePhase::fading);
}

TEST_CASE(
    "haptic loop: a silent lesson, a dead one, one that is over, a silent world: each fades") {
    for (int kind = 0; kind < 6; ++kind) {
        Bench bench(make_weight_plan());
        hold(bench);
        Fault expected = Fault::command_stale;
        switch (kind) {
            case 0:
                bench.lesson_awake = false;
                break;
            case 1:
                bench.world_awake = false;
                break;
            case 2:
                bench.command.lesson_alive = false;
                expected = Fault::lesson_failed;
                break;
            case 3:
                bench.channels->lesson_failed.store(true);
                expected = Fault::lesson_failed;
                break;
            case 4:
                bench.channels->ended.store(true);
                expected = Fault::ended;
                break;
            default:
                bench.world.carried_force_W.x() = std::numeric_limits<double>::infinity();
                expected = Fault::command_invalid;
        }
        bench.run(99);
        if (kind < 2) {
            CHECK(bench.loop.state().gate == GatePhase::open);
            bench.run(2);
        }
        CHECK(saw(bench, expected));
        CHECK(saw(bench, Fault::lesson_failed) == (expected == Fault::lesson_failed));
        CHECK(bench.loop.state().gate != GatePhase::open);
        bench.run(101);
        CHECK(bench.device.written_D.force.norm() == 0.0);
        // It comes back, softly, when all is well again and the hand is empty.
        bench.lesson_awake = bench.world_awake = bench.command.lesson_alive = true;
        bench.channels->lesson_failed.store(false);
        bench.channels->ended.store(false);
        bench.world.carried_force_W.setZero();
        bench.run(1000);
        CHECK(bench.loop.state().faults == Fault::none);
        CHECK(bench.loop.state().gate == GatePhase::rising);
    }
}

TEST_CASE("haptic loop: a plan without lesson and world does not wait for them") {
    HapticPlan plan;
    plan.expects_lesson = false;
    Bench bench(plan);
    bench.lesson_awake = bench.world_awake = false;
    bench.run(100);
    CHECK(bench.loop.state().faults == Fault::none);
}

TEST_CASE("haptic loop: the emergency stop latches until it is lifted and rearmed") {
    Bench bench(make_weight_plan());
    hold(bench);
    bench.channels->emergency_stop.press();
    bench.run(1);
    CHECK(bench.loop.state().gate == GatePhase::stopped);
    bench.run(100);
    CHECK(bench.device.written_D.force.norm() == 0.0);
    bench.channels->rearm.store(true);
    bench.run(10);
    CHECK(bench.loop.state().gate == GatePhase::stopped);
    bench.channels->rearm.store(false);
    bench.channels->emergency_stop.release();
    bench.run(1000);
    CHECK(bench.loop.state().gate == GatePhase::stopped);
    // Silence does not lift it.
    bench.loop.silence(bench.now_s);
    bench.run(10);
    CHECK(bench.loop.state().gate == GatePhase::stopped);
    bench.channels->rearm.store(true);
    bench.world.carried_force_W.setZero();
    bench.run(400);
    CHECK(bench.loop.state().gate == GatePhase::rising);
    CHECK_FALSE(bench.channels->rearm.load());
}

TEST_CASE("haptic loop: a stop that comes while an earlier one is being lifted stays") {
    Bench bench(make_weight_plan());
    hold(bench);
    bench.channels->emergency_stop.tap();
    bench.run(5);
    bench.channels->rearm.store(true);  // waits until the fade is over
    bench.run(5);
    REQUIRE(bench.device.written_D.force.norm() > 0.0);
    bench.channels->emergency_stop.tap();
    bench.world.carried_force_W.setZero();
    bench.run(1000);
    CHECK(bench.loop.state().gate == GatePhase::stopped);
    bench.channels->rearm.store(true);
    bench.run(10);
    CHECK(bench.loop.state().gate != GatePhase::stopped);
}

TEST_CASE("haptic loop: silence writes zero and the force must engage again") {
    Bench bench(make_weight_plan());
    hold(bench);
    bench.loop.silence(bench.now_s);
    CHECK(bench.device.written_D.force.norm() == 0.0);
    bench.run(10);
    CHECK(bench.device.written_D.force.norm() == 0.0);
    CHECK(bench.loop.state().gate == GatePhase::waiting);
}

TEST_CASE("haptic loop: a full recorder is a fault, an emptied one is none") {
    Bench bench(make_weight_plan());
    auto ring = std::make_unique<RecordRing>();
    bench.channels->record = ring.get();
    bench.run(static_cast<int>(kRecordRingCapacity));
    CHECK(bench.loop.state().faults == Fault::none);
    bench.run(2);
    CHECK(saw(bench, Fault::record_full));
    RecordRound round;
    REQUIRE(ring->pop(round));
    CHECK(round.sample.tick == 0);
    CHECK(round.sample.time_s == kDt_s);
    while (ring->pop(round)) {
    }
    CHECK(round.sample.tick == kRecordRingCapacity - 1);
    bench.run(2);
    CHECK(bench.loop.state().faults == Fault::none);
}

TEST_CASE(
    "haptic loop: time that stands still or runs back never gives a force that time would not") {
    Bench bench(make_weight_plan());
    hold(bench);
    bench.loop.step(bench.now_s - 0.5);
    CHECK(bench.device.written_D.force.norm() == 0.0);
    Bench nan_clock(make_weight_plan());
    hold(nan_clock);
    nan_clock.loop.step(std::numeric_limits<double>::quiet_NaN());
    CHECK(nan_clock.device.written_D.force.norm() == 0.0);
}

TEST_CASE("haptic loop: a stop lifted in the middle of its fade still fades to its end") {
    Bench bench(make_weight_plan());
    hold(bench);
    const double held_N = bench.device.written_D.force.norm();
    bench.channels->emergency_stop.press();
    bench.run(20);
    bench.channels->emergency_stop.release();
    bench.channels->rearm.store(true);
    double before_N = bench.device.written_D.force.norm();
    REQUIRE(before_N > 0.5 * held_N);
    for (int k = 0; k < 100; ++k) {
        bench.run(1);
        const double now_N = bench.device.written_D.force.norm();
        REQUIRE(before_N - now_N <= 1.01 * held_N * 0.001 / 0.1);
        REQUIRE(now_N <= before_N + 1e-12);
        before_N = now_N;
    }
    CHECK(before_N == 0.0);
}
