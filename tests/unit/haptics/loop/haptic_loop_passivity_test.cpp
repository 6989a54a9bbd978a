// Every effect of the loop tells the passivity stage what of its force gives the hand's work back.
#include "haptics/math/rotation.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

constexpr double kMotion_m = 1e-5;  // a round

HapticPlan watched(HapticPlan plan) {
    plan.passivity.headroom_J = 0.0;
    plan.passivity.memory_s = 10.0;
    return plan;
}

// Moves along x, and turns about y, for so many rounds.
void move(Bench& bench, int n) {
    for (int i = 0; i < n; ++i) {
        bench.device.pose_D.position.x() += kMotion_m;
        bench.device.pose_D.orientation =
            compute_exp(Vector3(0.0, 1e-3, 0.0)) * bench.device.pose_D.orientation;
        bench.command.linearised.stamp_s = bench.now_s + kDt_s;
        bench.run(1);
    }
}

}  // namespace

TEST_CASE("haptic loop: a declared spring leaks k d^2 / 2 in the first period, and is braked") {
    HapticPlan plan;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 200.0, 0.0}};
    Bench bench(watched(plan));
    bench.run(3000);
    REQUIRE(bench.loop.state().gate == GatePhase::open);
    move(bench, 1);
    CHECK(bench.loop.state().force_energy.excess_J == Approx(0.5 * 200.0 * kMotion_m * kMotion_m));
    CHECK(bench.loop.state().commanded_W.force.x() < -200.0 * kMotion_m * 1.5);
    move(bench, 50);
    CHECK(bench.loop.state().force_energy.braked_J > 10.0 * 200.0 * kMotion_m * kMotion_m);
}

TEST_CASE("haptic loop: a lesson's constant force and torque may be followed as far as one likes") {
    HapticPlan plan;
    plan.lesson_force = true;
    Bench bench(watched(plan));
    bench.run(3000);
    REQUIRE(bench.loop.state().gate == GatePhase::open);
    bench.command.linearised.force_W.x() = 0.5;
    bench.command.linearised.torque_W.y() = 0.05;
    move(bench, 1000);
    CHECK(bench.device.written_D.force.x() == Approx(0.5));
    CHECK(bench.device.written_D.torque.y() == Approx(0.05));
    CHECK(bench.loop.state().force_energy.peak_J < 1e-9);
    CHECK(bench.loop.state().torque_energy.peak_J < 1e-9);
    CHECK(bench.loop.state().force_energy.braked_J == 0.0);
    CHECK(bench.loop.state().torque_energy.braked_J == 0.0);
}

TEST_CASE("haptic loop: a weight that arrives while the hand moves under it is nobody's excess") {
    Bench bench(watched(make_weight_plan()));
    bench.run(3000);
    bench.world.carried_force_W = Vector3(-3.0, 0.0, 0.0);
    move(bench, 400);
    CHECK(bench.device.written_D.force.x() == Approx(-3.0));
    CHECK(bench.loop.state().force_energy.peak_J < 1e-12);
    bench.world.carried_force_W = Vector3(3.0, 0.0, 0.0);
    move(bench, 400);
    CHECK(bench.loop.state().force_energy.peak_J < 1e-12);
}

TEST_CASE("haptic loop: a torque that leaks is braked in the hand") {
    HapticPlan plan;
    plan.lesson_force = true;
    Bench bench(watched(plan));
    bench.command.linearised.torque_stiffness_Nm_per_m(1, 0) =
        -50.0;  // falls while the hand goes on
    bench.command.linearised.stamp_s = kDt_s;
    bench.run(3000);
    REQUIRE(bench.loop.state().gate == GatePhase::open);
    move(bench, 1);
    bench.run(100);  // the answer of that round is blended in
    move(bench, 1);
    const double plain_Nm = -50.0 * 2.0 * kMotion_m;
    CHECK(bench.loop.state().torque_energy.peak_J > 1e-8);
    CHECK(bench.loop.state().commanded_W.torque.y() < plain_Nm - 1e-4);
}

TEST_CASE("haptic loop: after a jump of the hand the count of its energy begins anew") {
    HapticPlan plan;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 20.0, 0.0}};
    Bench bench(watched(plan));
    bench.run(3000);
    move(bench, 20);
    const double peak_J = bench.loop.state().force_energy.peak_J;
    CHECK(peak_J > 0.0);
    bench.device.pose_D.position.x() = -1.0;
    bench.run(1);
    CHECK(saw(bench, Fault::device_invalid));
    CHECK(bench.loop.state().force_energy.excess_J == 0.0);
    CHECK(bench.loop.state().force_energy.peak_J == peak_J);
}
