#include "runtime/scene/plan_tool.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/scene/explain.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

// A solid block of 40 x 4 x 10 cm, and a cylinder in the hand.
LessonDescription make_lesson() {
    LessonDescription lesson;
    lesson.title = "A tool";
    lesson.id = "tool";
    BodyDescription body;
    body.name = body.noun = body.model = "block";
    body.solid = true;
    body.line = 4;
    lesson.bodies.push_back(body);
    lesson.hand.tool = ToolDescription{};
    lesson.hand.line = 7;
    return lesson;
}

Expected<std::shared_ptr<const CollisionMesh>> load_block(const BodyDescription& body) {
    const Vector3 size_m =
        body.model == "stick" ? Vector3(0.02, 0.3, 0.02) : Vector3(0.4, 0.04, 0.1);
    return make_box(size_m).and_then(
        [](const TriangleMesh& mesh) { return CollisionMesh::create(mesh); });
}

Expected<Plan> compile(const LessonDescription& lesson) {
    return compile_plan(lesson, {}, load_block);
}

std::string refusal(const LessonDescription& lesson) {
    const auto plan = compile(lesson);
    return plan ? "" : to_sentence(plan.error());
}

}  // namespace

TEST_CASE("plan: a tool in the hand is a stage of its own, instead of the proxy's") {
    for (const ToolMethod method : {ToolMethod::field_sampling, ToolMethod::voxel_sampling}) {
        LessonDescription lesson = make_lesson();
        lesson.hand.tool->method = method;
        const auto plan = compile(lesson);
        REQUIRE(plan);
        CHECK(validate(plan->haptic));
        CHECK(plan->has("haptic", "tool"));
        CHECK_FALSE(plan->has("haptic", "proxy"));
        CHECK_FALSE(plan->has("haptic", "forces: coupling"));
        REQUIRE(plan->haptic.tool);
        CHECK(plan->haptic.tool->n_objects() == 1);
        const std::string text = explain(lesson, *plan);
        CHECK(text.find("a cylinder meets bodies") != std::string::npos);
        CHECK(text.find("lesson.lua:7") != std::string::npos);
        CHECK(text.find("2000 points, backward Euler, 500 N/m") != std::string::npos);
        CHECK(text.find("block            4") != std::string::npos);
        CHECK(
            text.find(method == ToolMethod::voxel_sampling ? "voxel sampling" : "field sampling") !=
            std::string::npos);
    }
}

TEST_CASE("plan: without a tool nothing of it is there") {
    LessonDescription lesson = make_lesson();
    lesson.hand.tool.reset();
    const auto plan = compile(lesson);
    REQUIRE(plan);
    CHECK(plan->haptic.tool == nullptr);
    CHECK_FALSE(plan->has("haptic", "tool"));
    CHECK(plan->has("haptic", "proxy"));
    for (const char* words : {"The tool in the hand", "voxel"}) {
        CHECK(explain(lesson, *plan).find(words) == std::string::npos);
    }
}

TEST_CASE("plan: a tool's mass and springs are as the hand feels them, at every scale") {
    for (const double scale : {1.0, 4.0}) {
        LessonDescription lesson = make_lesson();
        lesson.hand.scale = scale;
        lesson.hand.tool->mass_kg = 0.04;
        lesson.hand.tool->stiffness_N_per_m = 300.0;
        lesson.hand.tool->turn_stiffness_Nm_per_rad = 0.2;
        const auto plan = compile(lesson);
        REQUIRE(plan);
        const VoxelToolSettings& settings = plan->haptic.tool->settings;
        CHECK(settings.inertia.mass_kg == Approx(0.04 / scale));
        CHECK(settings.coupling.shift.stiffness_N_per_m == Approx(300.0 / scale));
        CHECK(settings.coupling.turn.stiffness_Nm_per_rad == Approx(0.2 * scale));
        // A cylinder of 4 x 10 cm: m r^2 / 2 about its axis.
        CHECK(settings.inertia.moments_kg_m2.minCoeff() ==
              Approx(0.5 * 0.04 / scale * 0.02 * 0.02).epsilon(0.01));
    }
}

TEST_CASE(
    "plan: where a tool's turn has no stiffness of its own its far end is as stiff as the spring") {
    const auto plan = compile(make_lesson());
    REQUIRE(plan);
    const double reach_m = std::hypot(0.02, 0.05);
    CHECK(plan->haptic.tool->settings.coupling.turn.stiffness_Nm_per_rad ==
          Approx(500.0 * reach_m * reach_m).epsilon(0.03));
}

TEST_CASE("plan: each shape is a tool, and a model too") {
    for (const CursorShape& shape :
         {CursorShape{SphereShape{0.02}}, CursorShape{BoxShape{Vector3(0.01, 0.03, 0.02)}},
          CursorShape{CapsuleShape{0.01, 0.03}}, CursorShape{CylinderShape{0.01, 0.03}}}) {
        LessonDescription lesson = make_lesson();
        lesson.hand.tool->shape = shape;
        CHECK(compile(lesson));
    }
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->shape = std::monostate{};
    lesson.hand.tool->model = "stick";
    const auto plan = compile(lesson);
    REQUIRE(plan);
    CHECK(name_of(*lesson.hand.tool) == "stick");
    // It is held upright, as its model stands, whatever its principal axes are.
    const VoxelToolSettings& settings = plan->haptic.tool->settings;
    CHECK(settings.grip_T.norm() < 1e-9);
    const Vector3 thin = settings.handle_turn * Vector3::UnitX();
    CHECK(std::abs(thin.y()) == Approx(1.0));
}

TEST_CASE("plan: mistakes with a tool get one sentence and a line") {
    LessonDescription lesson = make_lesson();
    lesson.bodies[0].solid = false;
    CHECK(refusal(lesson).find("lesson.lua:7: the hand has a tool, and no body is solid") == 0);
    lesson = make_lesson();
    lesson.hand.tool->voxel_m = 0.0005;
    CHECK(refusal(lesson).find("lesson.lua:7: voxels of 0.5 mm are too small for the block") == 0);
    lesson = make_lesson();
    MaterialDescription wood;
    wood.felt.name = "wood";
    lesson.materials.push_back(wood);
    lesson.bodies[0].material = 0;
    CHECK(refusal(lesson).find("lesson.lua:4: the block has a material, and a tool feels") == 0);
    lesson = make_lesson();
    lesson.bucket.present = true;
    CHECK(refusal(lesson).find("lesson.lua:7: the hand has a tool and a bucket") == 0);
    lesson = make_lesson();
    lesson.hand.tool->shape = std::monostate{};
    CHECK(refusal(lesson).find("lesson.lua:7: the tool") == 0);
}
