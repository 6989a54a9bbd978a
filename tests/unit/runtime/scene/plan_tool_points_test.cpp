// How many points a tool has.
#include "haptics/loop/haptic_loop.h"
#include "haptics/tool/tool_plan.h"
#include "tests/unit/runtime/scene/plan_scene.h"

using namespace fulcrum::runtime::test;

TEST_CASE("plan: among voxels a tool has a point a voxel, or fewer as is said or told") {
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->method = ToolMethod::voxel_sampling;
    lesson.hand.tool->voxel_m = 0.001;
    // A cylinder of 2 cm and 10 cm has 15 000 square millimetres.
    const auto whole = plan_of(lesson);
    const std::size_t n = count_points(*whole.haptic.tool);
    CHECK(n > 12'000);
    CHECK(n <= 20'000);
    CHECK(whole.notices.empty());
    lesson.hand.rate_hz = 4000.0;
    const auto late = plan_of(lesson);
    CHECK(count_points(*late.haptic.tool) == 2000);
    REQUIRE(late.notices.size() == 1);
    CHECK(late.notices[0].find("lesson.lua:7: the tool: it has " + std::to_string(n) +
                               " voxels of its own, and a step has time for 5000 points") == 0);
    lesson.hand.tool->points = 3000;
    const auto chosen = plan_of(lesson);
    CHECK(count_points(*chosen.haptic.tool) == 3000);
    CHECK(chosen.notices.empty());
}
