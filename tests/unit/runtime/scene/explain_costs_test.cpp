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

TEST_CASE("explain costs: a line a timed stage with calls, times, share and memory, then errors") {
    const std::string text = explain_costs(make_plan(), make_analysis());
    check_says(text, {"Played 10.0 s in 0.50 s",
                      "haptic   read                  10000      0.100      0.200   25.0 %      72 "
                      "B\n",
                      "75.0 %    1.3 kB\n", "velocity, rms 1.5 mm/s, against the hand's own\n"});
    check_lacks(text, {"lua"});
}

TEST_CASE(
    "explain costs: what a knob leaves at the device stands with its reference, or why there is "
    "none") {
    Analysis analysis = make_analysis();
    analysis.knobs = {{.stage = 0,
                       .what = "rounds of 1000 Hz",
                       .against = "5000 Hz",
                       .seconds = 9.5,
                       .force_N = {0.001, 0.02, 0.3},
                       .torque_Nm = {1e-5, 2e-5, 3e-5},
                       .turns = true},
                      {.stage = 0, .what = "facets", .because = "nothing finer is known"},
                      {.stage = 2, .what = "answers of 60 Hz", .against = "each round"}};
    const std::string text = explain_costs(make_plan(), analysis);
    check_says(text,
               {"the first 9.5 s once more",
                "haptic   read              rounds of 1000 Hz: 0.001, 0.02, 0.3 N; 1e-05, "
                "2e-05, 3e-05 N m; against 5000 Hz\n",
                "haptic   read              facets: no reference: nothing finer is known\n",
                "lesson   lua               answers of 60 Hz: 0, 0, 0 N; against each round\n"});
    const auto json = nlohmann::json::parse(explain_json(make_lesson(), make_plan(), &analysis));
    const auto& knobs = json["stages"][0]["knobs"];
    REQUIRE(knobs.size() == 2);
    CHECK(knobs[0]["force_N"] == nlohmann::json({0.001, 0.02, 0.3}));
    CHECK(knobs[0]["torque_Nm"][2] == 3e-5);
    CHECK(knobs[0]["against"] == "5000 Hz");
    CHECK(knobs[0]["seconds"] == 9.5);
    CHECK(knobs[1]["force_N"].is_null());
    CHECK(knobs[1]["because"] == "nothing finer is known");
    CHECK_FALSE(json["stages"][1].contains("knobs"));
    CHECK(json["stages"][2]["knobs"].size() == 1);
    CHECK_FALSE(json["stages"][2]["knobs"][0].contains("torque_Nm"));
    check_lacks(explain_costs(make_plan(), make_analysis()), {"knob"});
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
