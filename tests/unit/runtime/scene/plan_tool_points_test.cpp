// How many points a tool has.
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/scene/plan.h"

#include <catch2/catch.hpp>

#include <memory>
#include <string>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

// A solid block of 40 x 4 x 10 cm, and a cylinder in the hand.
LessonDescription make_lesson() {
    LessonDescription lesson;
    lesson.title = lesson.id = "tool";
    BodyDescription body;
    body.name = body.noun = body.model = "block";
    body.solid = true;
    body.line = 4;
    lesson.bodies.push_back(body);
    lesson.hand.tool = ToolDescription{};
    lesson.hand.line = 7;
    return lesson;
}

Expected<Plan> compile(const LessonDescription& lesson) {
    return compile_plan(lesson, {}, [](const BodyDescription& /*body*/) {
        return make_box({0.4, 0.04, 0.1}).and_then([](const TriangleMesh& mesh) {
            return CollisionMesh::create(mesh);
        });
    });
}

}  // namespace

TEST_CASE(
    "plan: among voxels a tool has a point a voxel, unless the lesson says fewer or a step has no "
    "time for them, which is told") {
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->method = ToolMethod::voxel_sampling;
    lesson.hand.tool->voxel_m = 0.001;
    // A cylinder of 2 cm and 10 cm has 15 000 square millimetres.
    const auto whole = compile(lesson);
    REQUIRE(whole);
    const std::size_t n = count_points(*whole->haptic.tool);
    CHECK(n > 12'000);
    CHECK(n <= 20'000);
    CHECK(whole->notices.empty());
    lesson.hand.rate_hz = 4000.0;
    const auto late = compile(lesson);
    REQUIRE(late);
    CHECK(count_points(*late->haptic.tool) == 2000);
    REQUIRE(late->notices.size() == 1);
    CHECK(late->notices[0].find("lesson.lua:7: the tool: it has " + std::to_string(n) +
                                " voxels of its own, and a step has time for 5000 points") == 0);
    lesson.hand.tool->points = 3000;
    const auto chosen = compile(lesson);
    REQUIRE(chosen);
    CHECK(count_points(*chosen->haptic.tool) == 3000);
    CHECK(chosen->notices.empty());
}
