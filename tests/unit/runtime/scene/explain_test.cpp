#include "runtime/scene/explain.h"

#include <catch2/catch.hpp>

using namespace fulcrum::runtime;

TEST_CASE("explain: every stage stands on a line of its own with rate, memory, asker and reason") {
    LessonDescription lesson;
    lesson.id = "gravity";
    lesson.title = "Which is heavier?";
    Plan plan;
    plan.stages = {{"haptic", "weight", 1000.0, 96, "a body can be carried", 14},
                   {"lesson", "dialogue", 0.0, 0, "it asks questions", 20},
                   {"sound", "mixer", 100.0, 2500000, "there is somebody to hear it", 0}};
    const std::string text = explain(lesson, plan);
    CHECK(text.find("Which is heavier? (gravity)") == 0);
    CHECK(text.find("haptic   weight            1000 Hz          96 B  lesson.lua:14   a body can "
                    "be carried\n") != std::string::npos);
    CHECK(text.find("when needed") != std::string::npos);
    CHECK(text.find("2.5 MB  every lesson") != std::string::npos);
}

TEST_CASE("explain: bytes are given in the unit that people read") {
    CHECK(bytes_text(0) == "0 B");
    CHECK(bytes_text(999) == "999 B");
    CHECK(bytes_text(1500) == "1.5 kB");
    CHECK(bytes_text(61000000) == "61.0 MB");
}
