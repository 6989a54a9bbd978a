// What is told of a tool that feels materials (plan_tool.h).
#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/scene/explain.h"
#include "runtime/scene/plan_tool.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

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

}  // namespace

TEST_CASE(
    "plan: a god-object's tool feels the friction of materials, and what it does not feel is told "
    "and left out") {
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->method = ToolMethod::god_object;
    MaterialDescription rubber;
    rubber.felt.name = "rubber";
    rubber.felt.friction = {0.9, 0.7, 0.0};
    rubber.felt.texture.source = SineTexture{};
    rubber.line = 3;
    lesson.materials.push_back(rubber);
    lesson.bodies[0].material = 0;
    const auto plan = compile(lesson);
    REQUIRE(plan);
    CHECK(validate(plan->haptic));
    const auto& objects = std::get<std::vector<GodObjectPlan>>(plan->haptic.tool->objects);
    CHECK(objects[0].friction.static_coefficient == 0.9);
    CHECK(objects[0].friction.dynamic_coefficient == 0.7);
    CHECK_FALSE(plan->has("haptic", "texture"));
    CHECK_FALSE(plan->haptic.solids[0].coupling.has_value());
    const std::string text = explain(lesson, *plan);
    CHECK(text.find("friction 0.9, 0.7 while it slides") != std::string::npos);
    REQUIRE(plan->notices.size() == 1);
    CHECK(plan->notices[0].find("rubber: a tool feels its friction, and neither its stiffness") <
          plan->notices[0].size());
    const auto tool = nlohmann::json::parse(explain_json(lesson, *plan, nullptr)).at("tool");
    CHECK(tool["bodies"][0]["friction"] == 0.9);
    // Without friction nothing is told of it.
    lesson.bodies[0].material = kNoMaterial;
    CHECK(explain(lesson, *compile(lesson)).find("while it slides") == std::string::npos);
}
