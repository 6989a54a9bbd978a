// Lessons and meshes that plans are made of, for tests of what is planned.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "runtime/scene/compile_plan.h"
#include "tests/support/touchable.h"
#include "tests/unit/runtime/rig.h"

namespace fulcrum::runtime::test {

/// A body whose name is its noun and its model; solid and seen.
inline BodyDescription make_solid(const std::string& name, SourceLine line = 4) {
    BodyDescription body;
    body.name = body.noun = body.model = name;
    body.solid = body.visible = true;
    body.line = line;
    return body;
}

/// A lesson with a solid block, and a tool in the hand: a cylinder, asked for in line 7.
inline LessonDescription make_lesson() {
    LessonDescription lesson;
    lesson.title = "A tool";
    lesson.id = "tool";
    lesson.bodies = {make_solid("block")};
    lesson.hand.tool.emplace();
    lesson.hand.line = 7;
    return lesson;
}

/// Each body is a box of this size.
inline SolidLoader load_as(const Vector3& size_m) {
    return [size_m](const BodyDescription& /*body*/) { return touchable(make_box(size_m)); };
}

/// Of 40 x 4 x 10 cm, or a stick.
inline Expected<std::shared_ptr<const CollisionMesh>> load_block(const BodyDescription& body) {
    return touchable(
        make_box(body.model == "stick" ? Vector3(0.02, 0.3, 0.02) : Vector3(0.4, 0.04, 0.1)));
}

/// As large as the lesson says.
inline Expected<std::shared_ptr<const CollisionMesh>> box_mesh(const BodyDescription& body) {
    return touchable(make_box(box_size_m(body)));
}

/// The plan; where there is none the test ends with the sentence that says why.
inline Plan plan_of(const LessonDescription& lesson, const SolidLoader& load = load_block,
                    const PlanOptions& options = {}) {
    return value_of(compile_plan(lesson, options, load));
}

/// The sentence that says why there is no plan; "" where there is one.
inline std::string refusal(const LessonDescription& lesson, const SolidLoader& load = load_block,
                           const PlanOptions& options = {}) {
    return refusal_of(compile_plan(lesson, options, load));
}

/// The number that follows `words`; 0 where they are not said.
inline double number_after(const std::string& sentence, const std::string& words) {
    const std::size_t at = sentence.find(words);
    return at == std::string::npos ? 0.0
                                   : std::strtod(sentence.c_str() + at + words.size(), nullptr);
}

/// The stage of this name; fails the test where there is none.
inline const PlanStage& stage_of(const Plan& plan, const std::string& loop,
                                 const std::string& name) {
    const auto stage = std::ranges::find_if(
        plan.stages, [&](const PlanStage& each) { return each.loop == loop && each.name == name; });
    REQUIRE(stage != plan.stages.end());
    return *stage;
}

}  // namespace fulcrum::runtime::test
