// Lessons that ask, judge and finish in unusual order, in Lua: an innocent lesson is never ended for it.
#include "tests/lessons/program.h"

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
    check_run(run, 0, {"told b true", "finished"}, {"told a"});
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
    check_run(run, 0, {"finished"});
}

TEST_CASE("questions: right() may finish the lesson") {
    const ProgramRun run = play(R"(
question("a", function(a) the_world:finish { stars = 2 }; return true end)
local asked = false
function L:update(world, dt)
  if not asked then asked = true; world:ask "a" end
end
)");
    check_run(run, 0, {"2 of 3 stars"});
}

namespace {

// One question four times, felt again where the ladder says so.
std::string climb_in(const Sandbox& sandbox, const std::string& lesson_fields,
                     const std::string& question_fields, const std::string& options) {
    sandbox.write("odd/lesson.lua", R"(
local game = require "game"
local L = lesson { id = "q", title = "Q", minutes = 1)" +
                                        lesson_fields +
                                        R"( }
function L:start(world)
  world:body { name = "egg", visible = true, model = "sphere" }
  game.play(L, world, function()
    for i = 1, 4 do
      game.ask("q", { again = function(answer) world:caption("Felt again: " .. answer.thing) end })
    end
  end)
end
L:question "q" { prompt = "Which one is the heaviest?", answers = { "the {thing} is the <superlative:heavy>" },
  right = function(a) return true end)" +
                                        question_fields + " }\nreturn L\n");
    sandbox.write("say.txt",
                  "the egg is most heavy\nthe egg is most heavy\nthe egg is most heavy\nthe egg is "
                  "most heavy\n");
    const ProgramRun run = sandbox.run("run odd --headless --say say.txt " + options);
    INFO(run.output);
    CHECK(run.exit_code == 0);
    std::string steps;
    for (std::size_t at = 0; at < run.output.size();) {
        const std::size_t end = std::min(run.output.find('\n', at), run.output.size());
        const std::string line = run.output.substr(at, end - at);
        at = end + 1;
        steps += line.find("Felt again: egg") != std::string::npos     ? "felt "
                 : line.find("Say it once more") != std::string::npos  ? "prompt "
                 : line.find("A short word gets") != std::string::npos ? "rule "
                 : line.find("answers  Yes.") != std::string::npos     ? "recast "
                                                                       : "";
    }
    return steps;
}

std::string climb(const std::string& lesson_fields, const std::string& question_fields,
                  const std::string& options = "") {
    return climb_in(Sandbox(), lesson_fields, question_fields, options);
}

}  // namespace

TEST_CASE("questions: lesson, question and who starts the program choose the steps of feedback") {
    CHECK(climb("", "") == "recast prompt rule rule ");
    const std::string of_lesson = ", feedback = { \"rule\", \"recast\" }";
    CHECK(climb(of_lesson, "") == "rule recast recast recast ");
    const std::string of_question = ", feedback = { \"replay\", \"prompt\" }";
    CHECK(climb(of_lesson, of_question) == "recast felt prompt prompt prompt ");
    CHECK(climb(of_lesson, of_question, "--feedback recast,replay") ==
          "recast recast felt recast felt recast felt ");
}

TEST_CASE("questions: a ladder that is chosen for a learner is kept until another is, or none") {
    const Sandbox sandbox;
    const auto play = [&](const std::string& options) {
        return climb_in(sandbox, ", feedback = { \"recast\" }", "", "--db p.db " + options);
    };
    const std::string of_lesson = "recast recast recast recast ";
    CHECK(play("--learner Mina") == of_lesson);
    CHECK(play("--learner Mina --feedback rule") == "rule rule rule rule ");
    CHECK(play("--learner Mina") == "rule rule rule rule ");
    CHECK(play("--learner Tom") == of_lesson);
    CHECK(play("") == of_lesson);
    CHECK(play("--learner Mina --feedback lesson") == of_lesson);
    CHECK(play("--learner Mina") == of_lesson);
}
