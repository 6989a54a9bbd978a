#include "runtime/scene/plan.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("plan: free English is checked only where a lesson with questions wants it") {
    LessonDescription lesson;
    lesson.id = lesson.title = "q";
    lesson.free_english = true;
    const auto silent = value_of(compile_plan(lesson, {}, {}));
    CHECK_FALSE(silent.has("lesson", "free English"));
    lesson.questions.resize(1);
    const auto asking = value_of(compile_plan(lesson, {}, {}));
    CHECK(asking.free_english);
    CHECK(asking.has("lesson", "free English"));
    lesson.free_english = false;
    CHECK_FALSE(compile_plan(lesson, {}, {})->has("lesson", "free English"));
}
