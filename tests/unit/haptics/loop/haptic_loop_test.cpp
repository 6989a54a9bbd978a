#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

using namespace fulcrum;

TEST_CASE("haptic loop: a carried weight arrives softly, in full, in the device's frame") {
    HapticPlan plan = make_weight_plan();
    plan.workspace.pose_WD.orientation = compute_exp(Vector3(0.0, 0.0, 1.5707963267948966));
    plan.workspace.scale = 3.0;
    Bench bench(plan);
    bench.run(3000);
    CHECK(bench.state().gate == GatePhase::open);
    bench.world.carried_force_W = Vector3(0.0, -3.0, 0.0);
    double before_N = 0.0;
    for (int k = 0; k < 301; ++k) {
        bench.run(1);
        const double now_N = bench.written_N().norm();
        REQUIRE(now_N >= before_N - kRounding);
        REQUIRE(now_N - before_N <= 1.875 * 3.0 / plan.weight_onset_s * kDt_s + kRounding);
        before_N = now_N;
    }
    // World down is the device's -x: R^T (0, -3, 0) for a quarter turn about z.
    CHECK((bench.written_N() - Vector3(-3.0, 0.0, 0.0)).norm() < kRounding);
    CHECK((bench.state().applied_W.force - Vector3(0.0, -3.0, 0.0)).norm() < kRounding);
    CHECK((bench.state().commanded_W.force - Vector3(0.0, -3.0, 0.0)).norm() < kRounding);
}

TEST_CASE("haptic loop: poses and velocities are scaled and turned into the world") {
    HapticPlan plan;
    plan.workspace.pose_WD = {Vector3(1.0, 0.0, 0.0),
                              compute_exp(Vector3(0.0, 0.0, 1.5707963267948966))};
    plan.workspace.scale = 5.0;
    Bench bench(plan);
    for (int k = 0; k < 100; ++k) {
        bench.device.pose_D.position = Vector3(0.0002 * k, 0.0, 0.0);
        bench.device.buttons = 2;
        bench.run(1);
    }
    const HapticState& state = bench.state();
    CHECK((state.tool_pose_W.position - Vector3(1.0, 5.0 * 0.0002 * 99, 0.0)).norm() < kRounding);
    CHECK((state.tool_twist_W.linear - Vector3(0.0, 1.0, 0.0)).norm() < 1e-6);
    CHECK(state.proxy_position_W == state.tool_pose_W.position);
    CHECK(state.buttons == 2);
    CHECK(state.tick == 99);
    CHECK(state.time_s == bench.now_s);
    REQUIRE(bench.channels->state_for_world.take());
    CHECK(bench.channels->state_for_world.value().tick == 99);
    REQUIRE(bench.channels->state_for_lesson.take());
    CHECK(bench.channels->state_for_lesson.value().tool_pose_W.position ==
          state.tool_pose_W.position);
}

TEST_CASE("haptic loop: fields and a lesson's force add up") {
    HapticPlan plan = make_lesson_plan();
    FieldPlan spring;
    spring.kind = FieldKind::spring;
    spring.stiffness_N_per_m = 100.0;
    FieldPlan magnet;
    magnet.kind = FieldKind::magnet;
    magnet.peak_force_N = 1.0;
    magnet.range_m = 0.02;
    plan.fields = {spring, magnet};
    Bench bench(plan);
    bench.command.fields[0].anchor_W = Vector3(0.01, 0.0, 0.0);
    bench.command.fields[1].anchor_W = Vector3(0.0, 0.02, 0.0);
    bench.command.fields[0].on = bench.command.fields[1].on = false;
    bench.run(3000);
    bench.command.fields[0].on = bench.command.fields[1].on = true;
    bench.command.linearised.stamp_s = bench.now_s;
    bench.command.linearised.force_W = Vector3(0.0, 0.0, 0.5);
    for (int k = 0; k < 1000; ++k) {
        bench.command.linearised.stamp_s = bench.now_s;
        bench.run(1);
    }
    CHECK((bench.written_N() - Vector3(1.0, 1.0, 0.5)).norm() < 1e-6);
    bench.command.linearised.stamp_s = bench.now_s + kDt_s;
    bench.command.linearised.force_W.x() = kNan;
    bench.run(1);
    CHECK(bench.saw(Fault::command_invalid));
}

TEST_CASE("haptic loop: a lesson's torque arrives in the device's frame, is capped and fades") {
    HapticPlan plan = make_lesson_plan();
    plan.workspace.pose_WD.orientation = compute_exp(Vector3(0.0, 0.0, 1.5707963267948966));
    plan.workspace.scale = 3.0;
    Bench bench(plan);
    bench.run(3000);
    REQUIRE(bench.state().gate == GatePhase::open);
    bench.command.linearised.torque_stiffness_Nm_per_m(1, 0) = 2.0;
    const auto answer = [&](const Vector3& torque_W, int n) {
        bench.command.linearised.torque_W = torque_W;
        for (int k = 0; k < n; ++k) {
            if (k % 16 == 0) {
                bench.command.linearised.stamp_s = bench.now_s + kDt_s;
            }
            bench.run(1);
        }
    };
    // World up is the device's x: R^T (0, 0.2, 0) for a quarter turn about z. No force comes with it.
    answer(Vector3(0.0, 0.2, 0.0), 200);
    CHECK((bench.device.written_D.torque - Vector3(0.2, 0.0, 0.0)).norm() < kRounding);
    CHECK(bench.written_N().norm() == 0.0);
    CHECK((bench.state().commanded_W.torque - Vector3(0.0, 0.2, 0.0)).norm() < kRounding);
    CHECK((bench.state().applied_W.torque - Vector3(0.0, 0.2, 0.0)).norm() < kRounding);
    // 1 cm of the device towards -y is 3 cm of the world towards +x, worth 0.06 Nm.
    bench.device.pose_D.position.y() = -0.01;
    bench.run(20);
    CHECK((bench.device.written_D.torque - Vector3(0.26, 0.0, 0.0)).norm() < kRounding);
    // Ten times the limit is as much as the limit.
    answer(Vector3(0.0, 3.0, 0.0), 500);
    CHECK(bench.state().commanded_W.torque.norm() == Approx(plan.safety.max_torque_Nm));
    CHECK(bench.device.written_D.torque.norm() <= plan.safety.max_torque_Nm);
    CHECK((bench.device.written_D.torque - Vector3(0.3, 0.0, 0.0)).norm() < kRounding);
    // The lesson goes silent: after its time the torque falls in a straight line to zero, and stays there.
    bench.lesson_awake = false;
    double before_Nm = 0.3;
    for (int k = 0; k < 400; ++k) {
        bench.run(1);
        const double now_Nm = bench.device.written_D.torque.norm();
        REQUIRE(now_Nm <= before_Nm + kRounding);
        REQUIRE(before_Nm - now_Nm <= 0.3 * kDt_s / plan.safety.fade_s + kRounding);
        before_Nm = now_Nm;
    }
    CHECK(bench.saw(Fault::command_stale));
    CHECK(bench.device.written_D.torque.norm() == 0.0);
    // One that is no number is a fault, and none of it reaches the device.
    Bench spoilt(make_lesson_plan());
    spoilt.run(3000);
    spoilt.command.linearised.stamp_s = spoilt.now_s + kDt_s;
    spoilt.command.linearised.torque_W.y() = kInfinity;
    spoilt.run(1);
    CHECK(spoilt.saw(Fault::command_invalid));
    CHECK(spoilt.device.written_D.torque.norm() == 0.0);
}

TEST_CASE("haptic loop: the record keeps what the device told, taken over or not") {
    const auto ring = std::make_unique<RecordRing>();
    Bench bench(HapticPlan{}, {.record = ring.get()});
    bench.run(10);
    bench.device.age_s = 0.05;
    bench.device.pose_D.position.x() = 0.001;
    bench.device.buttons = 4;
    bench.run(1);
    RecordRound round;
    while (ring->pop(round)) {
    }
    CHECK(any(round.sample.faults & Fault::device_stale));
    CHECK(round.sample.stamp_s == bench.now_s - 0.05);
    CHECK(round.sample.pose_D.position.x() == 0.001);
    CHECK(round.sample.buttons == 4);
    CHECK(bench.state().buttons == 0);
    // What is no pose is not kept: the record holds the last that was one.
    bench.device.pose_D.position.x() = kNan;
    bench.run(1);
    REQUIRE(ring->pop(round));
    CHECK(any(round.sample.faults & Fault::device_invalid));
    CHECK(round.sample.pose_D.position.x() == 0.001);
}
