// A lesson whose hand holds a tool, for tests of what is planned for it.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "runtime/scene/plan_tool.h"

#include <memory>

namespace fulcrum::runtime::test_scene {

/// A solid block of 40 x 4 x 10 cm, and a cylinder in the hand.
inline LessonDescription make_lesson() {
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

/// That block, or a stick.
inline Expected<std::shared_ptr<const CollisionMesh>> load_block(const BodyDescription& body) {
    const Vector3 size_m =
        body.model == "stick" ? Vector3(0.02, 0.3, 0.02) : Vector3(0.4, 0.04, 0.1);
    return make_box(size_m).and_then(
        [](const TriangleMesh& mesh) { return CollisionMesh::create(mesh); });
}

inline Expected<Plan> compile(const LessonDescription& lesson) {
    return compile_plan(lesson, {}, load_block);
}

}  // namespace fulcrum::runtime::test_scene
