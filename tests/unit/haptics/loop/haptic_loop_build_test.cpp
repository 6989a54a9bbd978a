#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <memory>
#include <string>

using namespace fulcrum;

TEST_CASE("haptic loop: what is not in the plan is not built") {
    ScriptedDevice device;
    auto channels = std::make_unique<HapticChannels>();
    const auto names = [&](const HapticPlan& plan) {
        std::string all;
        for (const StageInfo& stage : HapticLoop(plan, device, *channels).stages()) {
            CHECK(stage.rate_Hz == plan.rate_hz);
            CHECK(stage.bytes > 0);
            all += std::string(name_of(stage.stage)) + ", ";
        }
        return all;
    };
    CHECK(names(HapticPlan{}) == "take inputs, read, estimate, limits, write, publish, ");
    CHECK(names(make_weight_plan()) ==
          "take inputs, read, estimate, forces: weight, passivity, limits, write, publish, ");
    HapticPlan unwatched = make_weight_plan();
    unwatched.passivity.on = false;
    CHECK(names(unwatched) ==
          "take inputs, read, estimate, forces: weight, limits, write, publish, ");
    HapticPlan full = make_weight_plan();
    full.lesson_force = true;
    full.line = LineFeelSettings{};
    full.fields = {FieldPlan{FieldKind::magnet}, FieldPlan{FieldKind::viscosity}};
    full.solids.push_back({0, CollisionMesh::create(*make_box(Vector3(1, 1, 1))).value(), {}});
    RecordRing ring;
    channels->record = &ring;
    CHECK(names(full) ==
          "take inputs, read, estimate, proxy, forces: coupling, forces: weight, forces: magnet, "
          "forces: viscosity, forces: line, "
          "forces: lesson, passivity, limits, write, publish, record, ");
}

TEST_CASE(
    "haptic loop: the god-object is built from the plan's solids and holds the tool on a box") {
    HapticPlan plan;
    plan.expects_lesson = false;
    Pose below;
    below.position = Vector3(0.0, -0.5, 0.0);
    plan.solids.push_back({3, CollisionMesh::create(*make_box(Vector3(1, 1, 1))).value(), below});
    REQUIRE(validate(plan));
    ScriptedDevice device;
    auto channels = std::make_unique<HapticChannels>();
    HapticLoop loop(plan, device, *channels);
    device.pose_D.position = Vector3(0.1, 0.02, 0.1);
    for (int k = 1; k < 4000; ++k) {
        device.pose_D.position.y() = std::max(device.pose_D.position.y() - 0.00001, -0.004);
        loop.step(k * kDt_s);
    }
    CHECK(loop.state().touched_body == 3);
    CHECK(loop.state().proxy_position_W.y() == Approx(0.0).margin(1e-6));
    CHECK(device.written_D.force.y() == Approx(500.0 * 0.004).epsilon(1e-3));
}

TEST_CASE("haptic loop: plans out of range are refused") {
    CHECK(validate(HapticPlan{}));
    HapticPlan plan;
    plan.rate_hz = 500.0;
    REQUIRE_FALSE(validate(plan));
    CHECK(to_sentence(validate(plan).error()).find("1000 to 5000") != std::string::npos);
    plan = {};
    plan.safety.max_force_N = 11.0;
    CHECK_FALSE(validate(plan));
    plan = {};
    plan.workspace.scale = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(validate(plan));
    plan = {};
    plan.workspace.pose_WD.orientation.coeffs() *= 1.1;
    CHECK_FALSE(validate(plan));
    plan = {};
    plan.fields.resize(kMaxFields + 1);
    CHECK_FALSE(validate(plan));
    plan = {};
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 3000.0}};
    CHECK_FALSE(validate(plan));
    plan = {};
    plan.solids.resize(1);
    CHECK_FALSE(validate(plan));
    plan = {};
    plan.velocity_cutoff_hz = 0.0;
    CHECK_FALSE(validate(plan));
}

TEST_CASE(
    "haptic loop: each number of a plan is accepted at its bounds and refused just past them") {
    const auto accepts = [](auto change) {
        HapticPlan plan;
        change(plan);
        return validate(plan).has_value();
    };
    for (const double good : {0.01, 100.0}) {
        CHECK(accepts([&](HapticPlan& plan) { plan.workspace.scale = good; }));
    }
    for (const double bad : {0.0099, 100.1}) {
        CHECK_FALSE(accepts([&](HapticPlan& plan) { plan.workspace.scale = bad; }));
    }
    for (const double good : {1000.0, 5000.0}) {
        CHECK(accepts([&](HapticPlan& plan) { plan.rate_hz = good; }));
    }
    for (const double bad : {999.0, 5001.0}) {
        CHECK_FALSE(accepts([&](HapticPlan& plan) { plan.rate_hz = bad; }));
    }
    CHECK_FALSE(accepts([&](HapticPlan& plan) { plan.passivity.memory_s = 0.0; }));
    for (const double good : {0.02, 5.0}) {
        CHECK(accepts([&](HapticPlan& plan) { plan.weight_onset_s = good; }));
    }
    for (const double bad : {0.0199, 5.01}) {
        CHECK_FALSE(accepts([&](HapticPlan& plan) { plan.weight_onset_s = bad; }));
    }
    const auto turned = [&](double length) {
        return accepts(
            [&](HapticPlan& plan) { plan.workspace.pose_WD.orientation.coeffs() *= length; });
    };
    CHECK(turned(1.0 + 1e-10));
    CHECK_FALSE(turned(1.0 + 1e-8));
    CHECK_FALSE(turned(1.0 - 1e-8));
}

TEST_CASE("haptic loop: a device too coarse for the plan's scale is refused") {
    HapticPlan plan;
    plan.workspace.scale = 100.0;
    DeviceTraits traits;
    CHECK(validate(plan, traits));
    traits.position_resolution_m = 0.001;  // a tenth of a metre a step
    CHECK(validate(plan, traits));
    traits.position_resolution_m = 0.00101;
    REQUIRE_FALSE(validate(plan, traits));
    CHECK(to_sentence(validate(plan, traits).error()).find("resolution") != std::string::npos);
    plan.rate_hz = 500.0;
    traits.position_resolution_m = 0.0;
    CHECK_FALSE(validate(plan, traits));
}

TEST_CASE("haptic loop: velocity is estimated with the device's own step, in the world's metres") {
    constexpr double kStep_m = 0.001;
    constexpr double kScale = 5.0;
    ScriptedDevice device;
    device.traits_.position_resolution_m = kStep_m;
    auto channels = std::make_unique<HapticChannels>();
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.workspace.scale = kScale;
    HapticLoop loop(plan, device, *channels);
    VelocitySettings settings;
    settings.noise_bound_m = kStep_m * kScale;
    VelocityEstimator estimator(settings);
    for (int k = 1; k < 500; ++k) {
        // 0.3 m/s, counted in whole steps.
        device.pose_D.position.x() = kStep_m * std::floor(0.3 * k);
        loop.step(k * kDt_s);
        const Vector3& expected =
            estimator.step(Vector3(kScale * device.pose_D.position.x(), 0, 0), k * kDt_s);
        REQUIRE(loop.state().tool_twist_W.linear == expected);
        if (k > 20) {
            REQUIRE(expected.x() == Approx(kScale * 0.3).epsilon(0.5));
        }
    }
}

TEST_CASE("haptic loop: a Kalman filter sees the same hand at every scale of the workspace") {
    constexpr double kScale = 5.0;
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.velocity_method = VelocityMethod::kalman;
    ScriptedDevice device;
    device.traits_.position_resolution_m = 5.5e-5;
    auto channels = std::make_unique<HapticChannels>();
    auto scaled_channels = std::make_unique<HapticChannels>();
    HapticLoop loop(plan, device, *channels);
    plan.workspace.scale = kScale;
    HapticLoop scaled(plan, device, *scaled_channels);
    for (int k = 1; k < 500; ++k) {
        device.pose_D.position.x() = 5.5e-5 * std::round(200.0 * std::sin(0.02 * k));
        loop.step(k * kDt_s);
        scaled.step(k * kDt_s);
        // The first guess of the speed alone is not scaled.
        if (k > 50) {
            REQUIRE(scaled.state().tool_twist_W.linear.x() ==
                    Approx(kScale * loop.state().tool_twist_W.linear.x()).margin(1e-6));
        }
    }
}

TEST_CASE("haptic loop: the device's own torque limit holds when it is the smaller one") {
    HapticPlan plan;
    plan.lesson_force = true;
    ScriptedDevice device;
    device.traits_.max_torque_Nm = 0.1;
    auto channels = std::make_unique<HapticChannels>();
    HapticLoop loop(plan, device, *channels);
    ForceCommand command;
    command.lesson_alive = true;
    for (int k = 1; k < 4000; ++k) {
        command.stamp_s = command.linearised.stamp_s = k * kDt_s;
        command.linearised.torque_W.y() = k < 3000 ? 0.0 : 0.25;
        channels->command.publish(command);
        loop.step(k * kDt_s);
    }
    CHECK(device.written_D.torque.y() == Approx(0.1));
}

TEST_CASE("haptic loop: what a plan is when nobody says otherwise") {
    const HapticPlan plan;
    CHECK(plan.rate_hz == 1000.0);
    CHECK(plan.weight_onset_s == 0.3);
    CHECK(plan.velocity_cutoff_hz == 80.0);
    CHECK(plan.coupling.stiffness_N_per_m == 500.0);
    CHECK(plan.coupling.damping_Ns_per_m == 9.5);
    CHECK(plan.passivity.on);
    CHECK(plan.passivity.handle_mass_kg == kHandleMass_kg);
    CHECK(plan.passivity.headroom_J == 1.0e-4);
    CHECK(plan.passivity.memory_s == 0.1);
    CHECK(plan.safety.max_force_N == 5.0);
    CHECK(plan.safety.max_torque_Nm == 0.3);
    CHECK(plan.safety.max_slew_N_per_s == 500.0);
    CHECK(plan.safety.engage_below_N == 0.2);
    CHECK(plan.safety.engage_cycles == 5);
    CHECK(plan.safety.soft_start_N_per_s == 5.0);
    CHECK(plan.safety.soft_start_s == 2.0);
    CHECK(plan.safety.fade_s == 0.1);
    CHECK(plan.safety.command_timeout_s == 0.1);
    CHECK(plan.safety.device_timeout_s == 0.02);
    CHECK(plan.safety.max_hand_speed_m_per_s == 10.0);
}
