#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kMotion_m = 1e-5;  // a round

HapticPlan watched(HapticPlan plan) {
    plan.passivity.headroom_J = 0.0;
    plan.passivity.memory_s = 10.0;
    return plan;
}

// Behind an open gate; moves along x, and turns about y, for so many rounds.
struct WatchedBench : Bench {
    explicit WatchedBench(const HapticPlan& plan, double torque_slope_Nm_per_m = 0.0)
        : Bench(watched(plan)) {
        command.linearised.torque_stiffness_Nm_per_m(1, 0) = torque_slope_Nm_per_m;
        command.linearised.stamp_s = kDt_s;
        run(3000);
        REQUIRE(state().gate == GatePhase::open);
    }
    void move(int n) {
        for (int i = 0; i < n; ++i) {
            device.pose_D.position.x() += kMotion_m;
            device.pose_D.orientation =
                compute_exp(Vector3(0.0, 1e-3, 0.0)) * device.pose_D.orientation;
            command.linearised.stamp_s = now_s + kDt_s;
            run(1);
        }
    }
};

HapticPlan make_spring_plan(double stiffness_N_per_m) {
    HapticPlan plan;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), stiffness_N_per_m, 0.0}};
    return plan;
}

}  // namespace

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

// How steep a lesson's own force may be in the hand.

TEST_CASE("haptic loop: a lesson's slopes are bounded in the hand, by what the fields leave") {
    // How stiff a lesson's spring of 1e5 N/m is in the hand, and its damping and torque slope.
    struct Felt {
        double stiffness, damping, torque_slope;
    };
    const auto feel = [](double scale, const std::vector<FieldPlan>& fields) {
        HapticPlan plan = make_lesson_plan();
        plan.workspace.scale = scale;
        plan.passivity.on = false;  // a hand that leaps is braked as well
        plan.fields = fields;
        Bench bench(plan);
        bench.command.fields[0].on = false;
        bench.command.linearised.stamp_s = kDt_s;
        bench.command.linearised.stiffness_N_per_m(0, 0) = -1e5;
        bench.command.linearised.damping_Ns_per_m(1, 1) = -1e4;
        bench.command.linearised.torque_stiffness_Nm_per_m(2, 0) = 1e4;
        bench.run(20);
        bench.device.pose_D.position.x() = 0.0005;
        bench.run(20);
        const Wrench bent = bench.state().commanded_W;
        for (int k = 0; k < 20; ++k) {
            bench.move(0.0, 1e-5);
        }
        return Felt{-bent.force.x() / 0.0005, -bench.state().commanded_W.force.y() / 0.01,
                    bent.torque.z() / 0.0005};
    };
    for (const double scale : {1.0, 0.5, 100.0}) {
        const Felt alone = feel(scale, {});
        CHECK(alone.stiffness == Approx(2000.0).epsilon(1e-6));
        CHECK(alone.damping == Approx(50.0).epsilon(1e-3));
        CHECK(alone.torque_slope == Approx(200.0).epsilon(1e-6));
        FieldPlan spring;
        spring.stiffness_N_per_m = 1500.0 / scale;
        spring.damping_Ns_per_m = 40.0 / scale;
        const Felt beside = feel(scale, {spring});
        CHECK(beside.stiffness == Approx(500.0).epsilon(1e-6));
        CHECK(beside.damping == Approx(10.0).epsilon(1e-3));
        FieldPlan magnet;
        magnet.kind = FieldKind::magnet;
        magnet.peak_force_N = 3.0;
        magnet.range_m = 0.005 * scale;
        CHECK(feel(scale, {magnet}).stiffness ==
              Approx(2000.0 - 600.0 * std::sqrt(std::exp(1.0))).epsilon(1e-6));
    }
}

TEST_CASE("haptic loop: a lesson's spring too stiff for the scale does not shake the usual arm") {
    for (const double felt_N_per_m : {500.0, 2000.0, 5000.0, 200000.0}) {
        constexpr double kScale = 100.0;
        HapticPlan plan = make_lesson_plan();
        plan.workspace.scale = kScale;
        HandBench bench(plan);
        double lowest_m = 1.0;
        double highest_m = -1.0;
        for (int k = 1; k < 7000; ++k) {
            if (k % 16 == 0) {
                LinearisedWrench& answer = bench.command.linearised;
                answer.stamp_s = bench.now_s + kDt_s;
                answer.at_position_W = bench.state().tool_pose_W.position;
                answer.stiffness_N_per_m = -felt_N_per_m / kScale * Matrix3::Identity();
                answer.force_W = answer.stiffness_N_per_m * answer.at_position_W;
            }
            // The hand is pushed 5 mm aside for a second.
            bench.run_to({k > 3000 && k < 4000 ? 0.005 : 0.0, 0.0, 0.0});
            if (k > 5000) {
                const double x_m = bench.state().tool_pose_W.position.x() / kScale;
                lowest_m = std::min(lowest_m, x_m);
                highest_m = std::max(highest_m, x_m);
            }
        }
        CHECK(highest_m - lowest_m < 0.001);
        CHECK(std::abs(highest_m) < 0.002);
    }
}

// Every effect of the loop tells the passivity stage what of its force gives the hand's work back.

TEST_CASE("haptic loop: a spring leaks k d^2 / 2 a period, a torque leaks too; both are braked") {
    WatchedBench bench(make_spring_plan(200.0));
    bench.move(1);
    CHECK(bench.state().force_energy.excess_J == Approx(0.5 * 200.0 * kMotion_m * kMotion_m));
    CHECK(bench.state().commanded_W.force.x() < -200.0 * kMotion_m * 1.5);
    bench.move(50);
    CHECK(bench.state().force_energy.braked_J > 10.0 * 200.0 * kMotion_m * kMotion_m);
    WatchedBench other(make_lesson_plan(), -50.0);  // falls while the hand goes on
    other.move(1);
    other.run(100);  // the answer of that round is blended in
    other.move(1);
    const double plain_Nm = -50.0 * 2.0 * kMotion_m;
    CHECK(other.state().torque_energy.peak_J > 1e-8);
    CHECK(other.state().commanded_W.torque.y() < plain_Nm - 1e-4);
}

TEST_CASE("haptic loop: a constant force, and a weight that comes to a moving hand, is no excess") {
    WatchedBench bench(make_lesson_plan());
    bench.command.linearised.force_W.x() = 0.5;
    bench.command.linearised.torque_W.y() = 0.05;
    bench.move(1000);
    CHECK(bench.written_N().x() == Approx(0.5));
    CHECK(bench.device.written_D.torque.y() == Approx(0.05));
    CHECK(bench.state().force_energy.peak_J < 1e-9);
    CHECK(bench.state().torque_energy.peak_J < 1e-9);
    CHECK(bench.state().force_energy.braked_J == 0.0);
    CHECK(bench.state().torque_energy.braked_J == 0.0);
    WatchedBench bench_again(make_weight_plan());
    bench_again.world.carried_force_W = Vector3(-3.0, 0.0, 0.0);
    bench_again.move(400);
    CHECK(bench_again.written_N().x() == Approx(-3.0));
    CHECK(bench_again.state().force_energy.peak_J < 1e-12);
    bench_again.world.carried_force_W = Vector3(3.0, 0.0, 0.0);
    bench_again.move(400);
    CHECK(bench_again.state().force_energy.peak_J < 1e-12);
}

TEST_CASE("haptic loop: after a jump of the hand the count of its energy begins anew") {
    WatchedBench bench(make_spring_plan(20.0));
    bench.move(20);
    const double peak_J = bench.state().force_energy.peak_J;
    CHECK(peak_J > 0.0);
    bench.device.pose_D.position.x() = -1.0;
    bench.run(1);
    CHECK(bench.saw(Fault::device_invalid));
    CHECK(bench.state().force_energy.excess_J == 0.0);
    CHECK(bench.state().force_energy.peak_J == peak_J);
}
