// Lessons that ask, judge and finish in unusual order, in Lua: an innocent lesson is never ended for it.
#include "tests/lessons/program.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

const std::string kHead = R"(
local L = lesson { id = "q", title = "Q", level = "A1", minutes = 1 }
local apple, the_world
function L:start(world)
  world:gravity(9.81)
  world:ground(0)
  apple = world:body { name = "apple", noun = "apple", model = "sphere", movable = true, mass = 0.2, radius = 0.04 }
  the_world = world
end
local function question(name, right)
  L:question(name) { prompt = "Which one is heavy?", answers = { "[the] {thing} is heavy" }, right = right }
end
)";

ProgramRun play(const std::string& lesson) {
    const Sandbox sandbox;
    sandbox.write("odd/lesson.lua", kHead + lesson + "return L\n");
    sandbox.write("say.txt", "the apple is heavy\nthe apple is heavy\nthe apple is heavy\n");
    return sandbox.run("run odd --headless --seconds 20 --say say.txt");
}

}  // namespace

TEST_CASE("questions: another one may be asked by right() of the first") {
    const ProgramRun run = play(R"(
question("a", function(a) the_world:ask "b"; return true end)
question("b", function(a) return true end)
local asked = false
function L:update(world, dt)
  if not asked then asked = true; world:ask "a" end
end
function L:answered(answer)
  print("told " .. answer.question .. " " .. tostring(answer.right))
  the_world:finish { stars = 3 }
end
)");
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK(run.output.find("told b true") != std::string::npos);
    CHECK(run.output.find("told a") == std::string::npos);
    CHECK(run.output.find("finished") != std::string::npos);
}

TEST_CASE("questions: one may be asked in each frame, also in that of the answer") {
    const ProgramRun run = play(R"(
question("a", function(a) return true end)
question("b", function(a) return true end)
local n = 0
function L:update(world, dt)
  n = n + 1
  if n <= 150 then world:ask(n % 2 == 0 and "a" or "b") end
end
function L:answered(answer)
  if n > 150 then the_world:finish { stars = 3 } end
end
)");
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK(run.output.find("finished") != std::string::npos);
}

TEST_CASE("questions: right() may finish the lesson") {
    const ProgramRun run = play(R"(
question("a", function(a) the_world:finish { stars = 2 }; return true end)
local asked = false
function L:update(world, dt)
  if not asked then asked = true; world:ask "a" end
end
)");
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK(run.output.find("2 of 3 stars") != std::string::npos);
}
