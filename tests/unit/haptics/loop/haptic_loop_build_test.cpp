#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

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
            all += stage.name + ", ";
        }
        return all;
    };
    CHECK(names(HapticPlan{}) == "take inputs, read, estimate, limits, write, publish, ");
    CHECK(names(make_weight_plan()) ==
          "take inputs, read, estimate, forces: weight, limits, write, publish, ");
    HapticPlan full = make_weight_plan();
    full.lesson_force = true;
    full.fields = {FieldPlan{FieldKind::magnet}, FieldPlan{FieldKind::viscosity}};
    full.solids.push_back({0, CollisionMesh::create(*make_box(Vector3(1, 1, 1))).value(), {}});
    RecordRing ring;
    channels->record = &ring;
    CHECK(names(full) ==
          "take inputs, read, estimate, proxy, forces: coupling, forces: weight, forces: magnet, "
          "forces: viscosity, "
          "forces: lesson, limits, write, publish, record, ");
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
    CHECK(to_sentence(validate(plan).error()).find("1000 to 4000") != std::string::npos);
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
