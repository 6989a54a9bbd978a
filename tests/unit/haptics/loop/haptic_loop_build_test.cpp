// What is built of a plan, for a device; and which plans are none.
#include "haptics/geometry/shape.h"
#include "tests/support/refused.h"
#include "tests/support/touchable.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using namespace fulcrum;

namespace {

HapticPlan make_lonely_plan(double scale = 1.0) {
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.workspace.scale = scale;
    return plan;
}

DeviceTraits make_encoder(double step_m) {
    DeviceTraits traits = BenchParts{}.traits;
    traits.position_resolution_m = step_m;
    return traits;
}

}  // namespace

TEST_CASE("haptic loop: what is not in the plan is not built") {
    CHECK(Bench(HapticPlan{}).stages() == "take inputs, read, estimate, limits, write, publish, ");
    HapticPlan plan = make_weight_plan();
    CHECK(Bench(plan).stages() ==
          "take inputs, read, estimate, forces: weight, passivity, limits, write, publish, ");
    plan.passivity.on = false;
    CHECK(Bench(plan).stages() ==
          "take inputs, read, estimate, forces: weight, limits, write, publish, ");
    plan.passivity.on = true;
    plan.lesson_force = true;
    plan.line = LineFeelSettings{};
    plan.fields = {FieldPlan{FieldKind::magnet}, FieldPlan{FieldKind::viscosity}};
    plan.solids = only_solid(touchable(make_box(Vector3(1, 1, 1))));
    RecordRing ring;
    CHECK(Bench(plan, {.record = &ring}).stages() ==
          "take inputs, read, estimate, proxy, forces: coupling, forces: weight, forces: magnet, "
          "forces: viscosity, forces: line, "
          "forces: lesson, passivity, limits, write, publish, record, ");
}

TEST_CASE("haptic loop: the god-object is built of the plan's solids and holds the tool on a box") {
    HapticPlan plan = make_lonely_plan();
    plan.solids =
        only_solid(touchable(make_box(Vector3(1, 1, 1))), Pose::at(Vector3(0.0, -0.5, 0.0)));
    plan.solids[0].body = 3;
    REQUIRE(validate(plan));
    Bench bench(plan);
    bench.device.pose_D.position = Vector3(0.1, 0.02, 0.1);
    for (int k = 1; k < 4000; ++k) {
        bench.device.pose_D.position.y() =
            std::max(bench.device.pose_D.position.y() - 0.00001, -0.004);
        bench.run(1);
    }
    CHECK(bench.state().touched_body == 3);
    CHECK(bench.state().proxy_position_W.y() == Approx(0.0).margin(1e-6));
    CHECK(bench.written_N().y() == Approx(500.0 * 0.004).epsilon(1e-3));
}

TEST_CASE("haptic loop: plans out of range are refused, and accepted at their bounds") {
    using P = HapticPlan;
    check_ranges(
        P{},
        {{"workspace scale", [](P& p) -> double& { return p.workspace.scale; }, 0.01, 100.0},
         {"rate in hertz", [](P& p) -> double& { return p.rate_hz; }, kLeastRate_Hz, kMostRate_Hz},
         {"onset of a weight", [](P& p) -> double& { return p.weight_onset_s; }, 0.02, 5.0},
         {"max_force_N", [](P& p) -> double& { return p.safety.max_force_N; }, 0.5, 10.0}});
    check_refused(P{}, {[](P& p) { p.fields.resize(kMaxFields + 1); },
                        [](P& p) {
                            p.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 3000.0}};
                        },
                        [](P& p) { p.solids.resize(1); }, [](P& p) { p.velocity_cutoff_hz = 0.0; },
                        [](P& p) { p.passivity.memory_s = 0.0; }});
    for (const double length : {1.1, 1.0 + 1e-8, 1.0 - 1e-8, 1.0 + 1e-10}) {
        HapticPlan plan;
        plan.workspace.pose_WD.orientation.coeffs() *= length;
        CHECK(validate(plan).has_value() == (length == 1.0 + 1e-10));
    }
    HapticPlan slow;
    slow.rate_hz = 499.0;
    CHECK(is_refused(validate(slow), "500 to 5000"));
}

TEST_CASE("haptic loop: a device too coarse for the plan's scale is refused") {
    HapticPlan plan;
    plan.workspace.scale = 100.0;
    CHECK(validate(plan, DeviceTraits{}));
    CHECK(validate(plan, make_encoder(0.001)));  // a tenth of a metre a step
    CHECK(is_refused(validate(plan, make_encoder(0.00101)), "resolution"));
    plan.rate_hz = 499.0;
    CHECK_FALSE(validate(plan, make_encoder(0.0)));
}

TEST_CASE("haptic loop: velocity is estimated with the device's own step, in the world's metres") {
    constexpr double kStep_m = 0.001;
    constexpr double kScale = 5.0;
    Bench bench(make_lonely_plan(kScale), {.traits = make_encoder(kStep_m)});
    VelocitySettings settings;
    settings.noise_bound_m = kStep_m * kScale;
    VelocityEstimator estimator(settings);
    for (int k = 1; k < 500; ++k) {
        // 0.3 m/s, counted in whole steps.
        bench.device.pose_D.position.x() = kStep_m * std::floor(0.3 * k);
        bench.run(1);
        const Vector3& expected =
            estimator.step(Vector3(kScale * bench.device.pose_D.position.x(), 0, 0), bench.now_s);
        REQUIRE(bench.state().tool_twist_W.linear == expected);
        if (k > 20) {
            REQUIRE(expected.x() == Approx(kScale * 0.3).epsilon(0.5));
        }
    }
}

TEST_CASE("haptic loop: a Kalman filter sees the same hand at every scale of the workspace") {
    constexpr double kScale = 5.0;
    constexpr double kStep_m = 5.5e-5;
    const auto make = [](double scale) {
        HapticPlan plan = make_lonely_plan(scale);
        plan.velocity_method = VelocityMethod::kalman;
        return plan;
    };
    Bench plain(make(1.0), {.traits = make_encoder(kStep_m)});
    Bench scaled(make(kScale), {.traits = make_encoder(kStep_m)});
    for (int k = 1; k < 500; ++k) {
        for (Bench* bench : {&plain, &scaled}) {
            bench->device.pose_D.position.x() = kStep_m * std::round(200.0 * std::sin(0.02 * k));
            bench->run(1);
        }
        // The first guess of the speed alone is not scaled.
        if (k > 50) {
            REQUIRE(scaled.state().tool_twist_W.linear.x() ==
                    Approx(kScale * plain.state().tool_twist_W.linear.x()).margin(1e-6));
        }
    }
}

TEST_CASE("haptic loop: the device's own limits hold where they are the smaller ones") {
    HapticPlan plan = make_weight_plan();
    plan.lesson_force = true;
    struct Limits {
        double device_N, device_Nm;
        Vector3 felt_N;
        double felt_Nm;
    };
    // One that renders no torque is sent none, and its force is as ever.
    for (const Limits& limits :
         {Limits{2.0, 0.1, {0.0, -2.0, 0.0}, 0.1}, Limits{100.0, 0.0, {0.0, -4.0, 0.0}, 0.0}}) {
        CAPTURE(limits.device_N, limits.device_Nm);
        DeviceTraits traits = BenchParts{}.traits;
        traits.max_force_N = limits.device_N;
        traits.max_torque_Nm = limits.device_Nm;
        Bench bench(plan, {.traits = traits});
        for (int k = 1; k < 4000; ++k) {
            const bool is_on = k >= 3000;
            bench.command.linearised.stamp_s = bench.now_s + kDt_s;
            bench.command.linearised.torque_W.y() = is_on ? 0.25 : 0.0;
            bench.world.carried_force_W.y() = is_on ? -4.0 : 0.0;
            bench.run(1);
            REQUIRE(bench.device.written_D.torque.norm() <= limits.device_Nm);
        }
        CHECK((bench.written_N() - limits.felt_N).norm() < 1e-6);
        CHECK(bench.device.written_D.torque.y() == Approx(limits.felt_Nm));
        CHECK(bench.state().commanded_W.force.norm() == Approx(4.0));
        CHECK((bench.state().commanded_W.torque.norm() == 0.0) == (limits.device_Nm == 0.0));
    }
}
