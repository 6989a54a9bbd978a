#include "haptics/loop/haptic_loop.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/effect/tool/tool_springs.h"
#include "runtime/scene/explain.h"
#include "tests/unit/runtime/rig.h"
#include "tests/unit/runtime/scene/plan_scene.h"

#include <nlohmann/json.hpp>

using namespace fulcrum::runtime::test;

namespace {

// A tool of 2 cm by 10 cm, as the plan orders it.
struct Held {
    HandDescription hand;
    double reach_m = 0.054;
    double most_force_N = 5.0;
    Vector3 grip_T{Vector3::Zero()};

    Held() {
        hand.tool = ToolDescription{};
        hand.line = 4;
    }
    [[nodiscard]] std::string refusal() const {
        ToolOrder order;
        const double k = hand.tool->stiffness_N_per_m / hand.scale;
        order.settings.coupling.shift.stiffness_N_per_m = k;
        order.settings.coupling.turn.stiffness_Nm_per_rad = k * reach_m * reach_m;
        const double mass_kg = hand.tool->mass_kg / hand.scale;
        order.settings.inertia = make_ball_inertia(mass_kg, reach_m);
        order.settings.grip_T = grip_T;
        order.most_force_N = most_force_N;
        const auto good = check_tool_springs(hand, order, reach_m);
        return good ? "" : to_sentence(good.error());
    }
};

}  // namespace

TEST_CASE("tool springs: those of every hand and tool that can be are taken") {
    CHECK(Held().refusal().empty());
    for (const double scale : {0.1, 1.0, 10.0}) {
        for (const double stiffness : {100.0, 2000.0}) {
            Held held;
            held.hand.scale = scale;
            held.hand.tool->stiffness_N_per_m = stiffness;
            CHECK(held.refusal().empty());
        }
    }
}

TEST_CASE("tool springs: what cannot be is told in the lesson's own words, and what to do") {
    Held held;
    held.hand.scale = 0.01;
    held.hand.tool->stiffness_N_per_m = 2000.0;
    CHECK(held.refusal() ==
          "lesson.lua:4: the tool's stiffness of 2000 N/m in a hand at scale 0.01 is too stiff; "
          "give it less stiffness, or world:hand a scale nearer to 1.");
    held = Held();
    held.hand.scale = 100.0;
    held.hand.tool->stiffness_N_per_m = 50.0;
    CHECK(held.refusal() ==
          "lesson.lua:4: the tool's stiffness of 50 N/m in a hand at scale 100 is too soft: it "
          "would be pulled 10 m before it is felt; give it more stiffness, or world:hand a scale "
          "nearer to 1.");
    held = Held();
    held.reach_m = 1.732;
    CHECK(held.refusal() ==
          "lesson.lua:4: the tool reaches 1.73 m from its middle, and would be turned by a spring "
          "of 1500 Nm/rad; give it a turn_stiffness of at most 10, or make it smaller.");
    held = Held();
    held.grip_T = Vector3(0.0, 12.5, 0.0);
    CHECK(held.refusal() ==
          "lesson.lua:4: the middle of the tool's model lies 12.5 m from the model's origin, where "
          "the hand holds it; move it there in the program that made it.");
    held = Held();
    held.hand.scale = 0.02;
    held.hand.tool->mass_kg = 1.0;
    held.hand.tool->stiffness_N_per_m = 2000.0;
    CHECK(held.refusal().find("lesson.lua:4: a tool of 1 kg on a spring of 2000 N/m cannot be "
                              "calmed in a hand at scale 0.02; give it less mass") == 0);
    // No name of a setting that a lesson does not have.
    for (const char* word : {"_N_per_m", "clamp", "coupling"}) {
        check_lacks(held.refusal(), {word});
    }
}

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
    lesson.bodies[1].shading.on = true;
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
    lesson.hand.tool->shading.on = true;
    const auto round = plan_of(lesson);
    CHECK(std::get<std::vector<GodObjectPlan>>(round.haptic.tool->objects)[2].tool_shading);
}
