#include "runtime/scene/explain.h"
#include "tests/unit/runtime/rig.h"

#include <nlohmann/json.hpp>

using namespace fulcrum::runtime::test;

namespace {

Plan make_plan() {
    Plan plan;
    plan.stages = {{"haptic", "read", 1000.0, 72, "a hand holds it", 0},
                   {"haptic", "estimate", 1000.0, 1300, "a velocity is needed", 0},
                   {"lesson", "lua", 60.0, 0, "every lesson is a Lua file", 0}};
    return plan;
}

Analysis make_analysis() {
    Analysis analysis{10.0, 0.5, 0.02, {}};
    analysis.stages = {
        {0, 10000, 0.1, 0.2, 1000.0, {}},
        {1, 10000, 0.3, 0.4, 3000.0, {{"velocity, rms", 1.5, "mm/s", "the hand's own"}}}};
    return analysis;
}

LessonDescription make_lesson() {
    LessonDescription lesson;
    lesson.id = "stone";
    lesson.title = "Catch \"it\"";
    return lesson;
}

}  // namespace

TEST_CASE("explain costs: a line a timed stage with calls, times, share and memory, then errors") {
    const std::string text = explain_costs(make_plan(), make_analysis());
    check_says(text, {"Played 10.0 s in 0.50 s",
                      "haptic   read                  10000      0.100      0.200   25.0 %      72 "
                      "B\n",
                      "75.0 %    1.3 kB\n", "velocity, rms 1.5 mm/s, against the hand's own\n"});
    check_lacks(text, {"lua"});
}

TEST_CASE("explain costs: what nothing bounds is said not to be bounded, as JSON null") {
    Analysis analysis = make_analysis();
    analysis.stages.back().errors = {{"force off", std::nan(""), "N", "bodies that do not give"}};
    check_says(explain_costs(make_plan(), analysis),
               {"force off not bounded, against bodies that do not give\n"});
    const auto timed = nlohmann::json::parse(explain_json(make_lesson(), make_plan(), &analysis));
    CHECK(timed["stages"][1]["errors"][0]["value"].is_null());
}

TEST_CASE("explain costs: no heading of errors where there are none") {
    Analysis analysis = make_analysis();
    analysis.stages.pop_back();
    check_lacks(explain_costs(make_plan(), analysis), {"truth"});
}

TEST_CASE("explain json: the plan alone, and with figures where a stage was timed") {
    const auto plain = nlohmann::json::parse(explain_json(make_lesson(), make_plan(), nullptr));
    CHECK(plain["version"] == 1);
    CHECK(plain["lesson"] == "stone");
    CHECK(plain["title"] == "Catch \"it\"");
    REQUIRE(plain["stages"].size() == 3);
    CHECK(plain["stages"][0]["memory_bytes"] == 72);
    CHECK_FALSE(plain["stages"][0].contains("calls"));

    const Analysis analysis = make_analysis();
    const auto timed = nlohmann::json::parse(explain_json(make_lesson(), make_plan(), &analysis));
    CHECK(timed["simulated_s"] == 10.0);
    CHECK(timed["stages"][1]["calls"] == 10000);
    CHECK(timed["stages"][1]["share"] == Approx(0.75));
    CHECK(timed["stages"][1]["errors"][0]["unit"] == "mm/s");
    CHECK_FALSE(timed["stages"][2].contains("calls"));
}

TEST_CASE("explain json: what a hand finds out about each material") {
    LessonDescription lesson = make_lesson();
    Plan plan = make_plan();
    lesson.materials.resize(1);
    lesson.materials[0].felt.name = "felt";
    plan.material_facts.resize(1);
    plan.material_facts[0].hardness = 0.25;
    plan.material_facts[0].roughness = 0.5;
    plan.material_facts[0].slipperiness = 0.75;
    const auto whole = nlohmann::json::parse(explain_json(lesson, plan, nullptr));
    const nlohmann::json felt = {
        {"name", "felt"}, {"hardness", 0.25}, {"roughness", 0.5}, {"slipperiness", 0.75}};
    CHECK(whole["materials"] == nlohmann::json::array({felt}));
}

TEST_CASE("explain json: a title in no known encoding does not end the program") {
    LessonDescription lesson = make_lesson();
    lesson.title = "caf\xe9";
    const auto whole = nlohmann::json::parse(explain_json(lesson, make_plan(), nullptr));
    CHECK(whole["title"].get<std::string>().starts_with("caf"));
}
