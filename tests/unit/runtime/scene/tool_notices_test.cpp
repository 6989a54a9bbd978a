#include "runtime/scene/tool_notices.h"

#include "tests/unit/runtime/scene/plan_scene.h"

using namespace fulcrum::runtime::test;

namespace {

// A block of 40 x 20 x 40 cm, as thick as is asked for, and a ball of 1 cm in the hand, 30 cm up.
LessonDescription make_scene(ToolMethod method) {
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->shape = SphereShape{0.01};
    lesson.hand.tool->method = method;
    return lesson;
}

std::vector<std::string> notices_of(const LessonDescription& lesson, const Vector3& size_m) {
    return plan_of(lesson, load_as(size_m)).notices;
}

constexpr ToolMethod kMethods[]{ToolMethod::field_sampling, ToolMethod::voxel_sampling,
                                ToolMethod::implicit_penalty};

}  // namespace

TEST_CASE("tool notices: a wall thinner than two voxels is told, with the voxel that does") {
    for (const ToolMethod method : kMethods) {
        LessonDescription lesson = make_scene(method);
        lesson.hand.tool->voxel_m = 0.004;
        CHECK(notices_of(lesson, {0.4, 0.02, 0.4}).empty());
        const auto told = notices_of(lesson, {0.4, 0.003, 0.4});
        REQUIRE(told.size() == 1);
        CAPTURE(told[0]);
        CHECK(told[0].find("lesson.lua:4: the block: it has walls of 3 mm, and voxels of ") == 0);
        const std::string words = "give the tool a voxel of ";
        const auto at = told[0].find(words);
        REQUIRE(at != std::string::npos);
        lesson.hand.tool->voxel_m = std::stod(told[0].substr(at + words.size()));
        CHECK(lesson.hand.tool->voxel_m == Approx(0.0015));
        CHECK(notices_of(lesson, {0.4, 0.003, 0.4}).empty());
        // So thin that no voxels of that body do.
        const auto foil = notices_of(lesson, {0.4, 0.0005, 0.4});
        REQUIRE(foil.size() == 1);
        check_lacks(foil[0], {words});
        check_says(foil[0], {"m thick or more"});
    }
}

TEST_CASE("tool notices: a tool that begins inside a body is told, and one that does not is not") {
    for (const ToolMethod method : kMethods) {
        LessonDescription lesson = make_scene(method);
        const Vector3 size_m(0.4, 0.2, 0.4);
        CHECK(notices_of(lesson, size_m).empty());
        for (const double height_m : {0.0, 0.09, 0.105}) {
            lesson.hand.centre_W = {0.05, height_m, 0.0};
            const auto told = notices_of(lesson, size_m);
            REQUIRE(told.size() == 1);
            CHECK(told[0] ==
                  "lesson.lua:7: the tool begins inside the block, and nothing is felt of it until "
                  "it is outside; put the hand's centre or the block elsewhere.");
        }
        lesson.bodies[0].visible = false;  // put somewhere later
        CHECK(notices_of(lesson, size_m).empty());
    }
}
