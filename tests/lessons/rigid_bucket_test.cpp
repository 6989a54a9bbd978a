// A bucket among rigid bodies, in a lesson as a teacher writes it: what falls in weighs, what is let go does not, and an empty one weighs little.
#include "tests/lessons/program.h"
#include "tests/lessons/record_judge.h"

#include <string>

using namespace fulcrum::test;

namespace {

constexpr const char* kLesson = R"(local L = lesson { id = "pail", title = "Balls", level = "A1" }
local balls, dropped, let_go = {}, 0, false
function L:start(world)
  world:hand { centre = { 0, 0.3, 0 } }
  world:bucket {}
  for i = 1, 2 do
    balls[i] = world:body { name = "ball_" .. i, model = "sphere", radius = 0.03, mass = 0.1, rigid = true, visible = false, at = { 0, 0.6, 0 } }
  end
end
function L:update(world)
  if dropped < 2 and world.time > 3 + 2 * dropped then
    dropped = dropped + 1
    balls[dropped]:drop { at = { 0.02, 0.6, 0 } }
  end
  if world.time > 7 and not let_go then
    let_go = true
    world:release()
  end
end
function L:caught(body, speed) print("caught " .. body.name) end
function L:landed(body) print("landed " .. body.name) end
return L
)";

}  // namespace

TEST_CASE("bucket: rigid bodies that fall in are caught, weigh in the hand, and are let go") {
    const Sandbox sandbox;
    sandbox.write("pail/lesson.lua", kLesson);
    sandbox.write("pail/hand.lua",
                  "local motion = require 'motion'\nreturn motion.play(function()\n  "
                  "motion.start_at { 0, 0.3, 0 }\n  motion.wait(9)\nend)\n");
    check_run(sandbox.run("explain pail"), 0, {"bucket", "the hand holds it; hard, massive"});
    check_run(sandbox.run("run pail --headless --hand pail/hand.lua --seconds 9 --record r.rec"), 0,
              {"caught ball_1", "caught ball_2"}, {"landed"});
    const Record record = read_run(sandbox.path("r.rec"));
    CHECK(find_trouble(record).empty());
    constexpr double kBall_N = 0.1 * 9.81;
    constexpr double kEmpty_N = 0.05 * 9.81;
    const auto felt_N = [&](double time_s) {
        return -sample_at(record, time_s).applied_W.force.y();
    };
    CHECK(felt_N(2.9) == Approx(kEmpty_N).margin(0.01));
    CHECK(felt_N(4.9) == Approx(kEmpty_N + kBall_N).margin(0.02));
    CHECK(felt_N(6.9) == Approx(kEmpty_N + 2.0 * kBall_N).margin(0.02));
    CHECK(felt_N(8.5) == Approx(kEmpty_N).margin(0.02));
}

TEST_CASE("bucket: what falls beside it lands, and nothing of it is built where no body is rigid") {
    const Sandbox sandbox;
    std::string beside = kLesson;
    beside.replace(beside.find("0.02, 0.6, 0 }"), 4, "0.25");
    sandbox.write("pail/lesson.lua", beside);
    sandbox.write("pail/hand.lua", "return function() return 0, 0.3, 0 end\n");
    check_run(sandbox.run("run pail --headless --hand pail/hand.lua --seconds 6"), 0,
              {"landed ball_1", "landed ball_2"}, {"caught"});
    check_run(sandbox.run("explain gravity"), 0, {"the tool catches"}, {"the hand holds it"});
}

TEST_CASE("bucket: what is too heavy for the hand in all is told, and of one thing alone nothing") {
    const Sandbox sandbox;
    std::string heavy = kLesson;
    heavy.replace(heavy.find("mass = 0.1"), 10, "mass = 0.3");
    sandbox.write("pail/lesson.lua", heavy);
    // 50 g and two balls of 300 g: 6.38 N.
    check_run(sandbox.run("explain pail"), 0,
              {"The bucket and all that may fall into it weigh 6.38 N", "lesson.lua:5"},
              {"can only be pushed"});
    sandbox.write("pail/lesson.lua", kLesson);
    check_run(sandbox.run("explain pail"), 0, {}, {"may fall into it weigh"});
}
