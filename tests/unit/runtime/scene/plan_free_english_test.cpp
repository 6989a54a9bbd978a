#include "runtime/scene/plan.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::runtime;

TEST_CASE("plan: free English is checked only where a lesson with questions wants it") {
    LessonDescription lesson;
    lesson.id = lesson.title = "q";
    lesson.free_english = true;
    const auto silent = compile_plan(lesson, {}, {});
    REQUIRE(silent);
    CHECK_FALSE(silent->has("lesson", "free English"));
    lesson.questions.resize(1);
    const auto asking = compile_plan(lesson, {}, {});
    REQUIRE(asking);
    CHECK(asking->free_english);
    CHECK(asking->has("lesson", "free English"));
    lesson.free_english = false;
    CHECK_FALSE(compile_plan(lesson, {}, {})->has("lesson", "free English"));
}
