// What a file says instead of a pupil: all of it, and what was not said is told.
#include "tests/lessons/program.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum::test;

namespace {

const std::string kLesson = R"(
local story = require "story"
local L = lesson { id = "odd", title = "Odd", minutes = 1 }
require("know").things(L)
L:question "q" { prompt = "Is it an egg?", answers = { "it is an egg" }, right = function() return true end }
function L:start(world)
  world:body { name = "block", noun = "block", model = "box", visible = true, solid = true, material = "metal" }
  story(L, function()
    world:ask "q"
    story.wait_for "answered"
    world:finish { stars = 3 }
  end)
end
return L
)";

}  // namespace

TEST_CASE("say file: a question among a file's answers is put off, and the rest is said") {
    const Sandbox sandbox;
    sandbox.write("odd/lesson.lua", kLesson);
    sandbox.write("say.txt", "What is this?\nCan I eat it?\nit is an egg\nbla\n");
    const ProgramRun run = sandbox.run("run odd --headless --say say.txt");
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK(run.output.find("Good question! But first answer mine.") != std::string::npos);
    CHECK(run.output.find("I don't know that. Please answer my question first.") !=
          std::string::npos);
    CHECK(run.output.find("it is an egg (right)") != std::string::npos);
    CHECK(run.output.find("finished after") != std::string::npos);
    // What was not said is told, and so is a file that was too short.
    CHECK(run.output.find(
              "One line of the file was not said, \"bla\": the lesson was over before.") !=
          std::string::npos);
    sandbox.write("say.txt", "Can I eat it?\nbla\n");
    const ProgramRun left = sandbox.run("run odd --headless --say say.txt");
    INFO(left.output);
    CHECK(left.exit_code == 1);
    CHECK(left.output.find("The lesson asked, and all 2 lines of the file are said") !=
          std::string::npos);
    CHECK(left.output.find("1 answer.") != std::string::npos);
}
