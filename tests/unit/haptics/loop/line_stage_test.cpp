#include "haptics/loop/line_stage.h"

#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <memory>

using namespace fulcrum;

namespace {

HapticPlan make_line_plan() {
    HapticPlan plan;
    plan.line = LineFeelSettings{};
    plan.line->arm_T = {0.0, 0.05, 0.0};
    plan.expects_lesson = false;
    return plan;
}

// A loop that holds a line; the kite's side of it is played here.
struct Kite {
    std::unique_ptr<KiteChannels> kite = std::make_unique<KiteChannels>();
};
struct LineBench : Kite, Bench {
    LineBench() : Bench(make_line_plan(), {.kite = kite.get()}) {}
    void run(int n, const Vector3& force_W, const Vector3& hand_W = Vector3::Zero()) {
        for (int i = 0; i < n; ++i) {
            kite->line.publish({now_s + kDt_s, hand_W, force_W, 25.0, 20.0});
            Bench::run(1);
        }
    }
};

}  // namespace

TEST_CASE("line stage: pull and torque are felt, the kite is told, and a silent loop lets go") {
    LineBench bench;
    bench.run(6000, {2.0, 1.0, 0.0});
    CHECK((bench.written_N() - Vector3(2.0, 1.0, 0.0)).norm() < 1.0e-6);
    CHECK((bench.device.written_D.torque - Vector3(0.0, 0.0, -0.1)).norm() < 1.0e-6);
    REQUIRE(bench.kite->hand_W.take());
    CHECK(bench.kite->hand_W.value() == Vector3::Zero());
    LineBench other;
    other.run(6000, {3.0, 0.0, 0.0});
    CHECK(other.written_N().norm() > 2.9);
    other.Bench::run(250);
    CHECK(other.written_N().norm() == 0.0);
    CHECK(other.state().faults == Fault::none);
}

TEST_CASE(
    "line stage: a wind that drops brakes nothing; the round before is told from what is new") {
    LineBench bench;
    bench.run(6000, {4.0, 0.0, 0.0});
    REQUIRE(bench.written_N().norm() > 3.9);
    for (int i = 0; i < 300; ++i) {
        bench.device.pose_D.position.x() += 1.0e-4;
        // The pull where the hand is now: less each round.
        bench.run(1, {4.0 - 0.01 * i, 0.0, 0.0}, bench.device.pose_D.position);
    }
    // The world's change comes a seventh of a second late.
    CHECK(bench.written_N().x() < 2.1);
    // But for what any spring of 25 N/m gives away that is held for a round: k d^2 / 2.
    const double held_J = 300 * 0.5 * 25.0 * 1.0e-8;
    CHECK(bench.state().force_energy.braked_J < 1.01 * held_J);
    const auto channels = std::make_unique<KiteChannels>();
    LineStage stage(LineFeelSettings{}, channels.get());
    LineForce felt;
    for (int i = 0; i < 600; ++i) {
        channels->line.publish({0.0, Vector3::Zero(), {3.0, 0.0, 0.0}, 25.0, 20.0});
        felt = stage.step(Pose{}, 0.0, kDt_s);
    }
    CHECK((felt.force.now_W - felt.force.held_W).norm() < 1.0e-12);
    // The hand moves: both know it. The world changes: only the new one does.
    felt = stage.step(Pose::at({-0.02, 0.0, 0.0}), 0.0, kDt_s);
    CHECK(felt.force.now_W.x() == Approx(3.5));
    CHECK(felt.force.held_W.x() == Approx(3.5));
    channels->line.publish({0.0, Vector3::Zero(), {1.0, 0.0, 0.0}, 25.0, 20.0});
    felt = stage.step(Pose::at({-0.02, 0.0, 0.0}), 0.0, kDt_s);
    CHECK(felt.force.now_W.x() == Approx(3.5 - 2.0 * kDt_s / LineFeelSettings{}.smooth_s));
    CHECK(felt.force.held_W.x() == Approx(3.5));
    CHECK(felt.wrench_W.force == felt.force.now_W);
}

TEST_CASE("line stage: no kite, no pull; a bad line is refused; a strong pull comes back") {
    LineStage stage(LineFeelSettings{}, nullptr);
    CHECK(stage.step(Pose{}, 0.0, kDt_s).wrench_W.force == Vector3::Zero());
    HapticPlan plan = make_line_plan();
    CHECK(validate(plan));
    CHECK(has_torques(plan));
    plan.line->most_N = kNan;
    CHECK_FALSE(validate(plan));
    LineBench bench;
    bench.run(6000, {4.5, 0.0, 0.0});
    CHECK(bench.written_N().norm() > 4.4);
    bench.device.gives_pose = false;
    bench.run(500, {4.5, 0.0, 0.0});
    CHECK(bench.written_N().norm() == 0.0);
    bench.device.gives_pose = true;
    bench.run(6000, {4.5, 0.0, 0.0});
    CHECK(bench.written_N().norm() > 4.4);
}

TEST_CASE("line stage: of a pose that jumps or is none the kite is not told") {
    LineBench bench;
    bench.run(100, Vector3::Zero());
    REQUIRE(bench.kite->hand_W.take());
    // One sample from a metre away, and back: neither way is a hand's.
    bench.device.pose_D.position.x() = 1.0;
    bench.run(1, Vector3::Zero());
    bench.device.pose_D.position.x() = kNan;
    bench.run(3, Vector3::Zero());
    bench.device.pose_D.position.x() = 0.0;
    bench.run(1, Vector3::Zero());
    CHECK_FALSE(bench.kite->hand_W.take());
    bench.run(1, Vector3::Zero());
    REQUIRE(bench.kite->hand_W.take());
    CHECK(bench.kite->hand_W.value() == Vector3::Zero());
    // Who stays there is there.
    bench.device.pose_D.position.x() = 1.0;
    bench.run(2, Vector3::Zero());
    REQUIRE(bench.kite->hand_W.take());
    CHECK(bench.kite->hand_W.value().x() == 1.0);
}
