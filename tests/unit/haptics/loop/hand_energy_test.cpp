#include "haptics/loop/hand_guard.h"
#include "haptics/loop/passivity_stage.h"
#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;

Wrench force_along_x(double newtons) {
    return {{newtons, 0.0, 0.0}, Vector3::Zero()};
}

HapticPlan make_plan(double scale = 1.0, bool torque = false) {
    HapticPlan plan;
    plan.workspace.scale = scale;
    plan.carries_weight = true;
    plan.lesson_force = torque;
    plan.passivity.memory_s = 10.0;
    plan.passivity.headroom_J = 0.01;
    return plan;
}

DeviceTraits make_traits() {
    DeviceTraits traits;
    traits.renders_force = true;
    traits.max_force_N = 10.0;
    traits.max_torque_Nm = 1.0;
    return traits;
}

// One round behind an open gate.
Wrench move(PassivityStage& stage, const SceneDemand& demand, const Pose& tool_W) {
    const Wrench brake = stage.step(demand, tool_W, kDt_s);
    stage.sent({demand.wrench_W.force + brake.force, demand.wrench_W.torque + brake.torque});
    return brake;
}

SceneDemand make_spring(double force_N) {
    SceneDemand demand;
    demand.wrench_W.force = Vector3(0, force_N, 0);
    demand.force = {demand.wrench_W.force, demand.wrench_W.force};
    return demand;
}

}  // namespace

TEST_CASE("hand guard: a hand faster than its limit is a fault, a short jerk is none") {
    SafetySettings settings;
    settings.max_felt_speed_m_per_s = 3.0;
    HandGuard guard(settings);
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(guard.step({}, {0.0029, 0.0, 0.0}, Vector3::Zero(), kDt_s) == Fault::none);
    }
    CHECK(guard.speed_m_per_s() == Approx(2.9).epsilon(1e-6));
    Fault seen = Fault::none;
    for (int i = 0; i < 200; ++i) {
        seen |= guard.step({}, {0.0, 0.0032, 0.0}, Vector3::Zero(), kDt_s);
    }
    CHECK(any(seen & Fault::hand_too_fast));
    // One reading that is 5 mm off is no fast hand.
    HandGuard calm(settings);
    CHECK(calm.step({}, {0.005, 0.0, 0.0}, Vector3::Zero(), kDt_s) == Fault::none);
    CHECK(calm.step({}, {-0.005, 0.0, 0.0}, Vector3::Zero(), kDt_s) == Fault::none);
}

TEST_CASE("hand guard: energy given in a second is bounded, in closed form") {
    SafetySettings settings;
    settings.max_energy_J = 2.0;
    HandGuard guard(settings);
    // 4 N along 1 m/s are 4 W: E(t) = 4 s (1 - e^-t), 2 J after ln 2 = 0.693 s.
    int ticks = 0;
    while (guard.step(force_along_x(4.0), {0.001, 0.0, 0.0}, Vector3::Zero(), kDt_s) ==
           Fault::none) {
        REQUIRE(++ticks < 2000);
    }
    CHECK(ticks * kDt_s == Approx(0.693).epsilon(0.01));
    // Given back, it counts no more; what the hand puts in is no credit.
    HandGuard even(settings);
    for (int i = 0; i < 20'000; ++i) {
        const double way_m = i / 200 % 2 == 0 ? 0.001 : -0.001;
        REQUIRE(even.step(force_along_x(5.0), {way_m, 0.0, 0.0}, Vector3::Zero(), kDt_s) ==
                Fault::none);
    }
    CHECK(even.energy_J() >= 0.0);
    // A torque gives as much.
    HandGuard turned(settings);
    Fault seen = Fault::none;
    for (int i = 0; i < 1000; ++i) {
        seen |= turned.step({Vector3::Zero(), {0.0, 0.0, 1.0}}, Vector3::Zero(), {0.0, 0.0, 0.004},
                            kDt_s);
    }
    CHECK(any(seen & Fault::too_much_energy));
}

TEST_CASE("hand guard: what is not finite, or no time, is not counted; a new hand begins at zero") {
    HandGuard guard(SafetySettings{});
    CHECK(guard.step(force_along_x(kNan), {0.001, 0.0, 0.0}, Vector3::Zero(), kDt_s) ==
          Fault::none);
    CHECK(guard.step({}, {kNan, 0.0, 0.0}, Vector3::Zero(), kDt_s) == Fault::none);
    CHECK(guard.step(force_along_x(9.0), {9.0, 0.0, 0.0}, Vector3::Zero(), 0.0) == Fault::none);
    CHECK(guard.step(force_along_x(9.0), {9.0, 0.0, 0.0}, Vector3::Zero(), kNan) == Fault::none);
    CHECK(guard.speed_m_per_s() == 0.0);
    CHECK(guard.energy_J() == 0.0);
    SafetySettings settings;
    settings.max_energy_J = 0.5;
    guard = HandGuard(settings);
    for (int i = 0; i < 1000; ++i) {
        (void)guard.step(force_along_x(5.0), {0.002, 0.0, 0.0}, Vector3::Zero(), kDt_s);
    }
    guard.forget();
    CHECK(guard.step(force_along_x(5.0), {0.001, 0.0, 0.0}, Vector3::Zero(), kDt_s) == Fault::none);
}

TEST_CASE("passivity stage: energy is counted in the hand's metres, at any scale") {
    for (const double scale : {0.05, 1.0, 100.0}) {
        PassivityStage stage(make_plan(scale), make_traits());
        // 0.2 N over 0.2 mm of the hand: 1000 N/m in the hand.
        (void)move(stage, make_spring(0.0), Pose{});
        const Wrench brake = move(stage, make_spring(-0.2), Pose::at(Vector3(0, 2e-4 * scale, 0)));
        CHECK(stage.force_energy().excess_J == Approx(0.5 * 1000.0 * 4e-8));
        CHECK(brake.force.y() == Approx(-0.2));
        // The contact's energy, told in metres of the world, likewise.
        PassivityStage touching(make_plan(scale), make_traits());
        (void)move(touching, SceneDemand{}, Pose::at(Vector3(0, 1e-4 * scale, 0)));
        SceneDemand wall = make_spring(0.2);
        wall.contact = {wall.wrench_W.force, 0.5 * 0.2 * 2e-4 * scale};
        (void)move(touching, wall, Pose::at(Vector3(0, -2e-4 * scale, 0)));
        CHECK(touching.force_energy().excess_J == Approx(0.5 * 0.2 * 2e-4));
    }
}

TEST_CASE("passivity stage: the first pose is no motion, and after a jump all begins anew") {
    PassivityStage stage(make_plan(), make_traits());
    (void)move(stage, make_spring(1.0), Pose::at(Vector3(1, 2, 3)));
    CHECK(stage.force_energy().excess_J == 0.0);
    (void)move(stage, make_spring(0.9), Pose::at(Vector3(1, 2.001, 3)));
    CHECK(stage.force_energy().excess_J == Approx(0.5 * 0.1 * 0.001));
    stage.forget();
    CHECK(stage.force_energy().excess_J == 0.0);
    CHECK(move(stage, make_spring(1.0), Pose::at(Vector3(7, 7, 7))).force.norm() == 0.0);
    CHECK(stage.force_energy().excess_J == 0.0);
}

TEST_CASE("passivity stage: torque has a budget of its own, and none where there is no torque") {
    PassivityStage stage(make_plan(1.0, true), make_traits());
    const auto turned = [](double angle_rad) {
        return Pose{Vector3::Zero(), compute_exp(Vector3(0, angle_rad, 0))};
    };
    const auto demand = [](double torque_Nm) {
        SceneDemand scene;
        scene.wrench_W.torque = Vector3(0, torque_Nm, 0);
        scene.torque = {scene.wrench_W.torque, scene.wrench_W.torque};
        return scene;
    };
    // A constant torque may be followed as far as one likes.
    for (int k = 0; k < 100; ++k) {
        CHECK(move(stage, demand(0.1), turned(0.01 * k)).torque.norm() == 0.0);
    }
    CHECK(stage.torque_energy().excess_J == Approx(0.0).margin(1e-15));
    // A torsion spring leaks like a spring, and does not spend what translation has earned.
    (void)move(stage, demand(0.09), turned(0.01 * 100));
    CHECK(stage.torque_energy().excess_J == Approx(0.5 * 0.01 * 0.01));
    CHECK(stage.force_energy().excess_J == 0.0);
    const Wrench brake = move(stage, demand(0.08), turned(0.01 * 101));
    CHECK(brake.torque.y() < 0.0);
    CHECK(brake.torque.norm() <= 1.0e-5 / 0.008 * 0.01 / kDt_s * (1.0 + 1e-9));
    CHECK(brake.force.norm() == 0.0);

    DeviceTraits no_torque = make_traits();
    no_torque.max_torque_Nm = 0.0;
    for (PassivityStage& without :
         {std::ref(stage = PassivityStage(make_plan(), make_traits())),
          std::ref(stage = PassivityStage(make_plan(1.0, true), no_torque))}) {
        (void)move(without, demand(0.1), turned(0.0));
        CHECK(move(without, demand(0.05), turned(0.1)).torque.norm() == 0.0);
        CHECK(without.torque_energy().peak_J == 0.0);
    }
}

TEST_CASE("passivity stage: the device's friction counts; without a pose the brake is held") {
    DeviceTraits traits = make_traits();
    traits.damping_Ns_per_m = 0.4;
    PassivityStage stage(make_plan(100.0), traits);
    (void)move(stage, make_spring(0.0), Pose{});
    (void)move(stage, make_spring(-0.2), Pose::at(Vector3(0, 0.02, 0)));
    // 0.4 Ns/m against k T / 2 = 0.5 Ns/m.
    CHECK(stage.force_energy().excess_J == Approx((0.5 - 0.4) * 4e-8 / kDt_s));
    stage = PassivityStage(make_plan(), make_traits());
    const auto wait = [&](double force_N, double x_m) {
        const SceneDemand demand = make_spring(force_N);
        const Wrench brake = stage.step(demand, Pose::at(Vector3(0, x_m, 0)), kDt_s, false);
        stage.sent({demand.wrench_W.force + brake.force, brake.torque});
        return brake.force.y();
    };
    (void)move(stage, make_spring(0.0), Pose{});
    const double brake_N = move(stage, make_spring(-0.02), Pose::at(Vector3(0, 1e-4, 0))).force.y();
    REQUIRE(brake_N < 0.0);
    CHECK(wait(-0.02, 1e-4) == brake_N);
    CHECK(wait(-0.02, 1e-4) == brake_N);
    CHECK(wait(-0.02, 1e-4) == 0.0);
    // What is told next was gone in four rounds: at the brake's bound, m / 8 T, a fourth of what one round would give.
    const Wrench later = move(stage, make_spring(-20.0), Pose::at(Vector3(0, 0.0101, 0)));
    CHECK(-later.force.y() == Approx(kHandleMass_kg / 0.008 * 0.01 / (4.0 * kDt_s)));
}
