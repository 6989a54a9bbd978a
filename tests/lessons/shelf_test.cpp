// What is compared stands on a shelf while it is asked about, and is felt again at will.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

// An apple and an egg that nobody has caught; it prints where each goes. `put` is done before the question.
std::string shelf_lesson(const std::string& put) {
    return R"(
local game, shelf, story = require "game", require "shelf", require "story"
local L = lesson { id = "s", title = "S", minutes = 1 }
local apple, egg
local where = {}
function L:start(world)
  world:bucket {}
  apple = world:body { name = "apple", model = "apple", movable = true, mass = 0.2, radius = 0.04 }
  egg = world:body { name = "egg", model = "egg", movable = true, mass = 0.06, radius = 0.026 }
  shelf.build(L, world, { at = { 0, 0.36, -0.3 } })
  game.play(L, world, function()
)" + put + R"(
    game.ask("heavier")
  end)
end
function L:update(world)
  for _, body in ipairs { apple, egg } do
    if where[body] ~= body.where then print(body.name .. " " .. body.where) where[body] = body.where end
  end
end
L:question "heavier" { prompt = "Which one?", answers = { "the {thing} is <comparative:heavy>" }, again = "Once more.",
  right = function(a) return a.thing == "apple" end }
return L
)";
}

constexpr const char* kPut = "shelf.put(apple)\nshelf.put(egg)\n";

// Goes to the apple, stays there long, goes away and comes back; then to the egg.
constexpr const char* kHand = R"(
local motion = require "motion"
return motion.play(function()
  motion.start_at { 0, 0.3, 0 }
  motion.wait(3)
  motion.move_to({ -0.16, 0.5, 0 }, 1)
  motion.wait(6)
  motion.move_to({ 0, 0.3, 0 }, 0.5)
  motion.move_to({ -0.16, 0.5, 0 }, 0.5)
  motion.wait(4)
  motion.move_to({ 0.16, 0.5, 0 }, 0.5)
  motion.wait(4)
end)
)";

}  // namespace

TEST_CASE(
    "shelf: who goes to a thing while a question is open has it in the hand, then it stands "
    "there") {
    const Sandbox sandbox;
    sandbox.write("s/lesson.lua", shelf_lesson(kPut));
    const std::string hand = sandbox.write("s/hand.lua", kHand);
    const ProgramRun run =
        sandbox.run("run s --headless --seconds 25 --record a.rec --hand " + hand);
    INFO(run.output);
    CHECK(run.exit_code == 0);
    std::string went;
    std::istringstream lines(run.output);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("apple ") || line.starts_with("egg ")) {
            went += line + "\n";
        }
    }
    // Once for each time that the hand came.
    CHECK(went ==
          "apple hidden\negg hidden\napple placed\negg placed\n"
          "apple held\napple placed\napple held\napple placed\negg held\negg placed\n");
    const Record record = read_run(sandbox.path("a.rec"));
    CHECK(largest_force_N(record) == Approx(0.2 * 9.81).epsilon(0.05));
    REQUIRE(sandbox.run("run s --headless --seconds 25 --record b.rec --hand " + hand).exit_code ==
            0);
    CHECK(bytes_of(sandbox.path("a.rec")) == bytes_of(sandbox.path("b.rec")));
}

TEST_CASE("shelf: nobody who is not asked takes anything from it") {
    const Sandbox sandbox;
    sandbox.write("s/lesson.lua", shelf_lesson(std::string(kPut) + "story.wait(30)\n"));
    const std::string hand = sandbox.write("s/hand.lua", kHand);
    check_run(sandbox.run("run s --headless --seconds 25 --hand " + hand), 0, {"apple placed"},
              {"held"});
}

TEST_CASE("shelf: mistakes are told at the lesson's own line") {
    const Sandbox sandbox;
    const auto fails = [&](const std::string& put, const char* sentence) {
        sandbox.write("s/lesson.lua", shelf_lesson(put));
        check_run(sandbox.run("run s --headless --seconds 5"), 1, {"lesson.lua:12: ", sentence});
    };
    fails("shelf.put('apple')", "shelf.put takes a body; got the text \"apple\"");
    fails("shelf.feel(egg, 1)", "shelf.feel takes what stands there; put egg there first");
    fails("shelf.putt(egg)", "shelf has no putt");
}
