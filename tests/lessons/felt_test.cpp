// A force that the last gate keeps back is told by all that plays a lesson: a test that expects it fails, `check`, `run` and `explain` say for how
// long it was shut, why, and what to do.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

/// A constant force from the start, and a hand whose motion goes on as `moves` says.
void write_lesson(const Sandbox& sandbox, const std::string& moves, const std::string& expected) {
    sandbox.write("x/hand.lua",
                  "local motion = require \"motion\"\n"
                  "return motion.play(function(world)\n"
                  "  motion.start_at { 0, 0.3, 0 }\n  while true do " +
                      moves + " end\nend)\n");
    sandbox.write("x/lesson.lua", R"(local game = require "game"
local story = require "story"
local L = lesson { id = "x", title = "X" }
function L:start(world)
  world:hand {}:force(function(tool) return 3, 0, 0 end)
  game.play(L, world, function() story.wait(6) end)
end
L:test { hand = "hand.lua", expect = { felt = )" +
                                      expected + " } }\nreturn L\n");
}

}  // namespace

TEST_CASE("felt: a force that the gate keeps back fails the test that expects it, and is told") {
    const Sandbox sandbox;
    const std::string restless =
        "motion.move_to({ 0.1, 0.3, 0 }, 0.3) motion.move_to({ -0.1, 0.3, 0 }, 0.3)";
    const std::string told =
        "one that is there from the start waits until the hand has rested for "
        "half a second; let the hand rest";
    write_lesson(sandbox, restless, "true");
    check_run(sandbox.run("test x --by arm"), 1,
              {"lesson.lua:8: expected felt = true, but it is false.",
               "lesson.lua:8: the hand was asked to feel a force for ", "and felt none: " + told,
               "x: failed by arm"});
    check_run(sandbox.run("check x"), 0, {"lesson.lua:8: the hand was asked", told});
    check_run(sandbox.run("run x --headless"), 0, {"x: the hand was asked", told});
    check_run(sandbox.run("explain x --analyze"), 0,
              {"gate shut ", "s in which a force was asked"});
    // A mouse has no motor, so nothing is kept back.
    check_run(sandbox.run("test x --by mouse"), 0, {"x: passed by mouse"}, {"was asked"});

    write_lesson(sandbox, "motion.wait(1)", "true");
    check_run(sandbox.run("test x --by arm"), 0, {"x: passed by arm"}, {"was asked"});
    check_run(sandbox.run("check x"), 0, {"no mistakes found"}, {"was asked"});

    write_lesson(sandbox, "motion.wait(1)", "4");
    check_run(sandbox.run("check x"), 1, {"test.expect.felt is true or false; got 4"});
}
