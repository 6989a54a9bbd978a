// What a file says instead of a pupil: all of it, and what was not said is told.
#include "tests/lessons/program.h"

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
    check_run(run, 0,
              {"Good question! But first answer mine.",
               "I don't know that. Please answer my question first.", "it is an egg (right)",
               "finished after"});
    // What was not said is told, and so is a file that was too short.
    check_says(run.output,
               {"One line of the file was not said, \"bla\": the lesson was over before."});
    sandbox.write("say.txt", "Can I eat it?\nbla\n");
    check_run(sandbox.run("run odd --headless --say say.txt"), 1,
              {"The lesson asked, and all 2 lines of the file are said", "1 answer."});
}
