#include "haptics/math/rotation.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

TEST_CASE("actions: each becomes its command, in order") {
    HostedLesson lesson;
    REQUIRE(lesson.load("L:question 'q' { prompt = '?', answers = { 'a' }, right = print }\n"
                        "function L:update(world) world:caption 'c' world:ask 'q' world:score(-3) "
                        "world:level(2, 'Two') world:level(3) world:sound 'pop' "
                        "world:finish { stars = 2 } end") == "");
    REQUIRE(lesson.play() == "");
    REQUIRE(lesson.reply.commands.size() == 7);
    CHECK(std::get<CaptionCommand>(lesson.reply.commands[0]).text == "c");
    CHECK(std::get<AskCommand>(lesson.reply.commands[1]).question == "q");
    CHECK(std::get<ScoreCommand>(lesson.reply.commands[2]).score == -3);
    CHECK(std::get<LevelCommand>(lesson.reply.commands[3]).level == 2);
    CHECK(std::get<LevelCommand>(lesson.reply.commands[3]).title == "Two");
    CHECK(std::get<LevelCommand>(lesson.reply.commands[4]).title.empty());
    CHECK(std::get<SoundCommand>(lesson.reply.commands[5]).name == "pop");
    CHECK(std::get<FinishCommand>(lesson.reply.commands[6]).stars == 2);
}

TEST_CASE("actions: looking things up") {
    HostedLesson lesson;
    REQUIRE(lesson.load("function L:start(world) world:body { name = 'apple' } world:body { name = "
                        "'egg' } end\n"
                        "function L:update(world) local t = world:tool() print(#world:bodies(), "
                        "world:bodies()[2], world:find 'egg', world.time, t.x, t.vy, t.position.z, "
                        "t.force, t.torque, t.turn.z) end") == "");
    LessonFrame frame = lesson.frame();
    frame.time_s = 1.5;
    frame.tool_pose_W.position = Vector3(1, 2, 3);
    frame.tool_pose_W.orientation = compute_exp(Vector3(0, 0, std::numbers::pi / 4));
    frame.tool_twist_W.linear = Vector3(0, -4, 0);
    frame.applied_W = {Vector3(3, 0, 4), Vector3(0, 0.3, 0.4)};
    REQUIRE(lesson.play(frame) == "");
    CHECK(lesson.prints == "2\tegg\tegg\t1.5\t1.0\t-4.0\t3.0\t5.0\t0.5\t45.0;");
    CHECK(HostedLesson().start("world:body { name = 'apple' } world:find 'aple'") ==
          "lesson.lua:2: there is no body \"aple\"; did you mean \"apple\"?");
}

TEST_CASE("actions: a question that was never declared suggests the nearest") {
    HostedLesson lesson;
    CHECK(lesson.load("L:question 'heaviest' { prompt = '?', answers = { 'a' }, right = print "
                      "}\nfunction L:start(world) world:ask 'heavist' end") ==
          "lesson.lua:3: there is no question \"heavist\"; did you mean \"heaviest\"?");
}

TEST_CASE("past: a lesson that asks for it is told what was answered before, once it runs") {
    HostedLesson lesson;
    REQUIRE(lesson.load("function L:start(world) world:recall() end\n"
                        "function L:update(world)\n"
                        "  for i, p in ipairs(world.past) do\n"
                        "    print(i, p.lesson, p.question, p.asked, p.right, p.wrong_now, p.days, "
                        "p.points.article)\n"
                        "  end\nend") == "");
    CHECK(lesson.host->description().wants_past);
    ReadyEvent ready;
    ready.past = {{"lever", "near_far", 3, 2, 1, 0.5, {{"article", 4}}}};
    REQUIRE(lesson.play(lesson.frame({ready})) == "");
    CHECK(lesson.prints == "1\tlever\tnear_far\t3\t2\t1\t0.5\t4;");
    CHECK(
        HostedLesson().start("print(world.past)") ==
        "lesson.lua:2: world.past is only known to a lesson that asks for it; write world:recall() "
        "in L:start.");
    CHECK(HostedLesson().start("world:recall() print(world.past)") ==
          "lesson.lua:2: world.past is known once the lesson runs, in L:update and later, not in "
          "L:start.");
}

}  // namespace
}  // namespace fulcrum::runtime
