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

TEST_CASE("haptic loop: a declared spring leaks k d^2 / 2 in the first period, and is braked") {
    WatchedBench bench(make_spring_plan(200.0));
    bench.move(1);
    CHECK(bench.state().force_energy.excess_J == Approx(0.5 * 200.0 * kMotion_m * kMotion_m));
    CHECK(bench.state().commanded_W.force.x() < -200.0 * kMotion_m * 1.5);
    bench.move(50);
    CHECK(bench.state().force_energy.braked_J > 10.0 * 200.0 * kMotion_m * kMotion_m);
}

TEST_CASE("haptic loop: a lesson's constant force and torque may be followed as far as one likes") {
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
}

TEST_CASE("haptic loop: a weight that arrives while the hand moves under it is nobody's excess") {
    WatchedBench bench(make_weight_plan());
    bench.world.carried_force_W = Vector3(-3.0, 0.0, 0.0);
    bench.move(400);
    CHECK(bench.written_N().x() == Approx(-3.0));
    CHECK(bench.state().force_energy.peak_J < 1e-12);
    bench.world.carried_force_W = Vector3(3.0, 0.0, 0.0);
    bench.move(400);
    CHECK(bench.state().force_energy.peak_J < 1e-12);
}

TEST_CASE("haptic loop: a torque that leaks is braked in the hand") {
    WatchedBench bench(make_lesson_plan(), -50.0);  // falls while the hand goes on
    bench.move(1);
    bench.run(100);  // the answer of that round is blended in
    bench.move(1);
    const double plain_Nm = -50.0 * 2.0 * kMotion_m;
    CHECK(bench.state().torque_energy.peak_J > 1e-8);
    CHECK(bench.state().commanded_W.torque.y() < plain_Nm - 1e-4);
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
