// What is told of a tool that feels materials (plan_tool.h).
#include "haptics/loop/haptic_loop.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/scene/explain.h"
#include "tests/unit/runtime/scene/plan_scene.h"

#include <nlohmann/json.hpp>

using namespace fulcrum::runtime::test;

TEST_CASE("plan: a god-object's tool feels friction; what it does not feel is told, left out") {
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->method = ToolMethod::god_object;
    MaterialDescription rubber;
    rubber.felt.name = "rubber";
    rubber.felt.friction = {0.9, 0.7, 0.0};
    rubber.felt.texture.source = SineTexture{};
    rubber.line = 3;
    lesson.materials.push_back(rubber);
    lesson.bodies[0].material = 0;
    const auto plan = plan_of(lesson);
    CHECK(validate(plan.haptic));
    const auto& objects = std::get<std::vector<GodObjectPlan>>(plan.haptic.tool->objects);
    CHECK(objects[0].friction.static_coefficient == 0.9);
    CHECK(objects[0].friction.dynamic_coefficient == 0.7);
    CHECK_FALSE(plan.has("haptic", "texture"));
    CHECK_FALSE(plan.haptic.solids[0].coupling.has_value());
    const std::string text = explain(lesson, plan);
    check_says(text, {"friction 0.9, 0.7 while it slides"});
    REQUIRE(plan.notices.size() == 1);
    CHECK(plan.notices[0].find("rubber: a tool feels its friction and its texture, and neither") <
          plan.notices[0].size());
    check_says(text, {"texture up to 0.1 mm high"});
    const auto tool = nlohmann::json::parse(explain_json(lesson, plan, nullptr)).at("tool");
    CHECK(tool["bodies"][0]["friction"] == 0.9);
    CHECK(tool["bodies"][0]["texture_m"] == 1.0e-4);
    CHECK(tool["bodies"][0]["rounded"] == false);
    // Without friction and texture nothing is told of them.
    lesson.bodies[0].material = kNoMaterial;
    const std::string bare = explain(lesson, plan_of(lesson));
    check_lacks(bare, {"while it slides", "texture up to", "rounded"});
}

TEST_CASE("plan: a god-object's tool feels textures, made once, and even normals where rounded") {
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->method = ToolMethod::god_object;
    lesson.bodies.push_back(lesson.bodies[0]);
    lesson.bodies[1].name = lesson.bodies[1].noun = "other";
    lesson.bodies.push_back(lesson.bodies[0]);
    lesson.bodies[2].name = lesson.bodies[2].noun = "bare";
    MaterialDescription rubber;
    rubber.felt.name = "rubber";
    rubber.felt.texture.source = SineTexture{};
    lesson.materials.push_back(rubber);
    lesson.bodies[0].material = 0;
    lesson.bodies[1].material = 0;
    lesson.bodies[1].rounded = true;
    const auto plan = plan_of(lesson);
    CHECK(validate(plan.haptic));
    const auto& objects = std::get<std::vector<GodObjectPlan>>(plan.haptic.tool->objects);
    REQUIRE(objects.size() == 3);
    REQUIRE(objects[0].texture);
    CHECK(objects[1].texture == objects[0].texture);
    CHECK_FALSE(objects[2].texture);
    CHECK(objects[0].texture->settings().height_m == rubber.felt.texture.height_m);
    CHECK_FALSE(objects[0].object_shading);
    CHECK(objects[1].object_shading);
    CHECK_FALSE(objects[1].tool_shading);
    // What the tool feels no loop stage gives besides.
    for (const SolidPlan& solid : plan.haptic.solids) {
        CHECK_FALSE(solid.surface.texture.any());
        CHECK_FALSE(solid.surface.shading.on);
    }
    check_says(explain(lesson, plan), {"rounded: "});
    const auto told = nlohmann::json::parse(explain_json(lesson, plan, nullptr)).at("tool");
    CHECK(told["bodies"][1]["rounded"] == true);
    lesson.hand.tool->rounded = true;
    const auto round = plan_of(lesson);
    CHECK(std::get<std::vector<GodObjectPlan>>(round.haptic.tool->objects)[2].tool_shading);
}
