#include "runtime/scene/explain.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

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
    check_says(text,
               {"haptic   weight            1000 Hz          96 B  lesson.lua:14   a body can "
                "be carried\n",
                "when needed", "2.5 MB  every lesson"});
}

TEST_CASE("explain: each material is called what a hand finds it to be, the middle included") {
    LessonDescription lesson;
    Plan plan;
    check_lacks(explain(lesson, plan), {"finds out"});
    lesson.materials.resize(2);
    lesson.materials[0].felt.name = "felt";
    lesson.materials[0].line = 5;
    lesson.materials[1].felt.name = "ice";
    plan.material_facts.resize(2);
    plan.material_facts[0].hardness = 0.5;
    plan.material_facts[0].roughness = 0.49;
    plan.material_facts[0].slipperiness = 0.1;
    plan.material_facts[1].hardness = 0.2;
    plan.material_facts[1].roughness = 0.5;
    plan.material_facts[1].slipperiness = 0.5;
    const std::string text = explain(lesson, plan);
    check_says(text, {"felt             0.50 hard   0.49 smooth   0.10 sticky     lesson.lua:5\n",
                      "ice              0.20 soft   0.50 rough    0.50 slippery"});
}

TEST_CASE("explain: bytes are given in the unit that people read") {
    CHECK(bytes_text(0) == "0 B");
    CHECK(bytes_text(999) == "999 B");
    CHECK(bytes_text(1500) == "1.5 kB");
    CHECK(bytes_text(61000000) == "61.0 MB");
}

TEST_CASE("explain: lengths are told as people read them, without exponents") {
    const std::vector<std::pair<double, std::string>> lengths{
        {1.0e-5, "0.01 mm"}, {5.0e-5, "0.05 mm"},  {0.0005, "0.5 mm"},  {0.001, "1 mm"},
        {0.0125, "12.5 mm"}, {0.12, "120 mm"},     {0.0999, "99.9 mm"}, {0.99949, "999 mm"},
        {0.9996, "1 m"},     {1.234567, "1.23 m"}, {123.456, "123 m"},  {5000.0, "5000 m"}};
    for (const auto& [metres, text] : lengths) {
        CHECK(metres_text(metres) == text);
    }
}
