// Mistakes as a teacher makes them in a lesson that is right otherwise: the first line that check says names the cause.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

const std::string kLesson = R"(local game = require "game"
local know = require "know"
local L = lesson { id = "floating", title = "Floating", level = "A2" }
know.things(L)
L:question "float" {
  prompt = "Which block floats?",
  answers = { "[the|a] {thing} floats" },
  right = function(answer) return answer.thing == "wooden block" end,
}
L:question "heavier" {
  prompt = "Which block is heavier?",
  answers = { "[the|a] {thing} is <comparative:heavy> [than [the|a] {other}]" },
  right = function(answer) return answer.bodies.thing ~= nil and answer.thing == "metal block" end,
}
function L:start(world)
  world:body { name = "wood", noun = "wooden block", model = "box", rigid = true, radius = 0.04, density = 600, at = { -0.15, 0.3, 0 } }
  world:body { name = "metal", noun = "metal block", model = "box", rigid = true, radius = 0.04, density = 800, at = { 0.15, 0.3, 0 } }
  game.play(L, world, function()
    world:caption "Lift the blocks."
    game.ask("float", { hint = "Which one is light?", solution = "The wooden block floats." })
    game.ask("heavier", { hint = "Feel them again.", solution = "The metal block is heavier." })
  end)
end
return L
)";

/// What check says of the lesson with `right` instead of its words `wrong`.
std::string checked(const std::string& words = "", const std::string& instead = "") {
    const Sandbox sandbox;
    std::string lesson = kLesson;
    const std::size_t at = lesson.find(words);
    REQUIRE(at != std::string::npos);
    sandbox.write("x/lesson.lua", lesson.replace(at, words.size(), instead));
    return sandbox.run("check x").output;
}

}  // namespace

TEST_CASE("teachers' slips: without any there is nothing to say") {
    CHECK(checked() == "floating: no mistakes found.\n");
}

TEST_CASE("teachers' slips: the first line names the cause, and nothing else misleads") {
    const struct {
        const char *words, *instead, *begin;
    } rows[] = {
        {"L:question \"float\" {", "L:question \"float\"",
         "lesson.lua:5: the { behind L:question \"float\" is missing."},
        {"require \"know\"", "require \"now\"",
         "lesson.lua:2: require \"now\" failed: there is no now.lua beside the lesson nor in the "
         "library; did you mean \"know\"?"},
        {"game.ask(\"float\"", "game.ask(\"flaot\"",
         "lesson.lua:20: there is no question \"flaot\"; did you mean \"float\"?\n"
         "lesson.lua:5: question \"float\": nothing asks it; write game.ask \"float\", where "
         "\"flaot\" stands now."},
        {"model = \"box\"", "model = \"block\"",
         "lesson.lua:16: wood has a density, and no volume is known of model = \"block\""},
        {"answer.bodies.thing ~= nil", "answer.bodies.other.weight > 0",
         "lesson.lua:13: question \"heavier\", tried with "},
        {"at = { 0.15, 0.3, 0 }", "at = { -0.15, 0.3, 0 }",
         "lesson.lua:17: metal stands where wood of line 16 does; give one of them another `at`."},
        {"density = 800", "density = 900", "The metal block weighs 4.52 N"},
    };
    for (const auto& row : rows) {
        const std::string said = checked(row.words, row.instead);
        INFO(said);
        CHECK(said.starts_with(row.begin));
    }
    CHECK(checked("answer.bodies.thing ~= nil", "answer.bodies.other.weight > 0")
              .find("other has no value here; where it may be left out, ask first: if ….other "
                    "then … end") != std::string::npos);
}

TEST_CASE("teachers' slips: a noun that is written as a name is told once") {
    const std::string said = checked("noun = \"wooden block\"", "noun = \"Wooden block\"");
    INFO(said);
    CHECK(said.starts_with("lesson.lua:16: \"Wooden\" in the noun of \"wood\" has a capital"));
    CHECK(said.find("better is") == std::string::npos);
}

TEST_CASE("teachers' slips: English that is none is told with its sentence and line, once") {
    const struct {
        const char *words, *instead, *told;
    } rows[] = {
        {"The wooden block floats.", "The wooden block float.",
         "lesson.lua:20: \"The wooden block float.\" is no good English; write \"floats\" for "
         "\"float\".\n"},
        {"Lift the blocks.", "Lifts the block.",
         "lesson.lua:19: \"Lifts the block.\" is no good English; write \"Lift\" for "
         "\"Lifts\".\n"},
        {"Which one is light?", "Which one are light?",
         "lesson.lua:20: \"Which one are light?\" is no good English; write \"is\" for \"are\".\n"},
        {"Feel them again.", "Which one are light?",
         "lesson.lua:21: \"Which one are light?\" is no good English; write \"is\" for \"are\".\n"},
        {"Which block is heavier?", "Which block is more heavy?",
         "lesson.lua:11: question \"heavier\": \"Which block is more heavy?\" is no good English; "
         "better is \"Which block is heavier?\".\n"},
        {"Which block floats?", "Why float the wooden block?",
         "a grammar could not read them; read them once more:\nlesson.lua:6: \"Why float the "
         "wooden block\"\n"},
        {"Which block floats?", "What is made the wooden block?",
         "lesson.lua:6: \"What is made the wooden block\"\n"},
    };
    for (const auto& row : rows) {
        const std::string said = checked(row.words, row.instead);
        INFO(said);
        const std::size_t at = said.find(row.told);
        CHECK(at != std::string::npos);
        CHECK(said.find(row.instead, at + std::string(row.told).size()) == std::string::npos);
    }
    // The same sentence in two lines is told once, with both.
    const std::string said = checked("Feel them again.", "The wooden block float.");
    CHECK(said.find("lesson.lua:21: \"The wooden block float.\"") != std::string::npos);
}
