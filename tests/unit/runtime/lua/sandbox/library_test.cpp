// The modules of scripts/lib, run in a lesson as teachers use them.
#include "tests/unit/runtime/lua/lesson_player.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace fulcrum::runtime {
namespace {

using test::lesson_text;
using test::LessonFolder;
using test::Player;

constexpr const char* kStory = R"(
local story = require "story"
local wait, wait_for = story.wait, story.wait_for
L:question "q" { prompt = "?", answers = { "{thing}" }, right = function(a) return true end }
function L:start(world)
  local apple = world:body { name = "apple", movable = true }
  local egg = world:body { name = "egg", movable = true }
  world:bucket {}
  story(L, function()
)";

TEST_CASE("story: goes from wait to wait, by seconds and by events") {
    Player player;
    player.start(std::string(kStory) + R"(
    print "begin"
    wait(0.5)
    print "waited"
    local e = wait_for "caught"
    print(e.name, e.body, e.speed)
    e = wait_for { "caught", "landed", body = egg }
    print(e.name, e.body)
    e = wait_for { "key", timeout = 0.5 }
    print(e)
    e = wait_for("key", "released")
    print(e.key)
    print "end"
  end)
end)");
    CHECK(player.prints == "begin;");
    player.step();
    CHECK(player.prints == "begin;");
    player.step();
    CHECK(player.prints == "begin;waited;");
    player.step({BodyEvent{BodyEvent::Kind::landed, 0, 1.0}});  // not asked for
    player.step({BodyEvent{BodyEvent::Kind::caught, 0, 1.5},
                 BodyEvent{BodyEvent::Kind::landed, 0, 1.0},
                 BodyEvent{BodyEvent::Kind::landed, 1, 2.0}});  // three in one frame
    CHECK(player.prints == "begin;waited;caught\tapple\t1.5;landed\tegg;");
    player.step();
    player.step();
    CHECK(player.prints == "begin;waited;caught\tapple\t1.5;landed\tegg;nil;");
    player.step({KeyEvent{"space"}});
    CHECK(player.prints == "begin;waited;caught\tapple\t1.5;landed\tegg;nil;space;end;");
    player.step({KeyEvent{"space"}});  // a story that is over stays over
    CHECK(player.error.empty());
}

TEST_CASE(
    "story: asks, waits for a condition, and runs beside another and beside the lesson's own "
    "functions") {
    Player player;
    player.start(std::string(kStory) + R"(
    local a = story.ask(world, "q")
    print(a.said, a.right, a.thing)
    story.wait_until(function() return self.go end)
    print "went"
  end)
  story(L, function() wait_for "key" print "other" end)
end
function L:key(name) self.go = true print("own", name) end)");
    player.step();
    CHECK(std::holds_alternative<AskCommand>(player.last.commands.at(0)));
    player.step({AnsweredEvent{"q", "an egg", {{"thing", "egg"}}, true, true, true, true, 1}});
    CHECK(player.prints == "an egg\ttrue\tegg;");
    player.step({KeyEvent{"x"}});
    CHECK(player.prints == "an egg\ttrue\tegg;own\tx;other;went;");
}

TEST_CASE("story: waits for a condition no longer than it is told, and while one holds") {
    Player player;
    player.start(std::string(kStory) + R"(
    print(story.wait_until(function() return false end, 0.5))
    print(story.wait_until(function() return true end, 0.5))
    story.wait_while(function() return self.holds end, 0.5)
    print "held"
    story.wait_while(function() return false end, 0.5)
    print "let go"
  end)
end
function L:key(name) self.holds = name == "down" end)");
    player.step();
    CHECK(player.prints.empty());
    player.step();
    CHECK(player.prints == "false;true;");
    player.step({KeyEvent{"down"}});
    player.step({KeyEvent{"up"}});
    CHECK(player.prints == "false;true;");
    player.step({KeyEvent{"down"}});
    CHECK(player.prints == "false;true;held;");
    for (int i = 0; i < 3; ++i) {
        player.step();
    }
    CHECK(player.prints == "false;true;held;");
    player.step();
    CHECK(player.prints == "false;true;held;let go;");
}

TEST_CASE("story: a mistake in the story has file and line") {
    const LessonFolder folder;
    const auto sentence = [&](const std::string& line) {
        auto process = folder.start(lesson_text(std::string(kStory) + line + " end) end"));
        return process ? std::string("started") : to_sentence(process.error());
    };
    CHECK(
        sentence("wait_for 'cought'") ==
        "lesson.lua:11: story.wait_for knows caught, landed, touched, released, key and answered; "
        "got the text \"cought\".");
    CHECK(sentence("local x = nil + 1") ==
          "lesson.lua:11: attempt to perform arithmetic on a nil value.");
    CHECK(sentence("world:caption(3)") ==
          "lesson.lua:11: world:caption is a text of at most 1000 letters; got 3.");
}

TEST_CASE("story: what it is given wrong is told at the lesson's line, not the library's") {
    const LessonFolder folder;
    const auto sentence = [&](const std::string& line) {
        auto process = folder.start(lesson_text(std::string(kStory) + line + " end) end"));
        return process ? std::string("started") : to_sentence(process.error());
    };
    CHECK(sentence("story.wait()") == "lesson.lua:11: story.wait takes seconds; got nothing.");
    CHECK(sentence("wait('four')") ==
          "lesson.lua:11: story.wait takes seconds; got the text \"four\".");
    CHECK(sentence("story.wait_until(3)") ==
          "lesson.lua:11: story.wait_until takes a function; got 3.");
    CHECK(sentence("story.waitfor { 'caught' }") ==
          "lesson.lua:11: story has no waitfor; did you mean wait_for?");
    CHECK(sentence("local x = story[3]") == "lesson.lua:11: story has no 3.");
    CHECK(sentence("story.ask 'thick'") ==
          "lesson.lua:11: story.ask takes the world and the name of a question, story.ask(world, "
          "\"heaviest\"); got the text \"thick\" and nothing.");
    CHECK(sentence("story.ask(world, 'nothing')") ==
          "lesson.lua:11: there is no question \"nothing\".");
    CHECK(sentence("wait_for()") ==
          "lesson.lua:11: story.wait_for takes the name of an event, such as \"caught\"; got "
          "nothing.");
    CHECK(sentence("wait_for { 'caught', boddy = egg }") ==
          "lesson.lua:11: story.wait_for: no event \"caught\" has boddy = egg; an event has body, "
          "speed or key, and timeout is in seconds.");
    CHECK(
        sentence("wait_for { 'caught', body = 'egg' }") ==
        "lesson.lua:11: story.wait_for: no event \"caught\" has body = the text \"egg\"; an event "
        "has body, speed or key, and timeout is in seconds.");
    CHECK(sentence("wait_for { 'caught', timeout = 'x' }") ==
          "lesson.lua:11: story.wait_for's timeout is seconds; got the text \"x\".");
    CHECK(sentence("wait_for { 'key', 'answered', thing = 'egg' }") == "started");
    CHECK(sentence("local function deep() wait() end deep()") ==
          "lesson.lua:11: story.wait takes seconds; got nothing.");
}

TEST_CASE("story: outside a story nothing waits, and a story needs its lesson") {
    const LessonFolder folder;
    const auto sentence = [&](const std::string& line) {
        auto process =
            folder.start(lesson_text("local story = require 'story'\nfunction "
                                     "L:start(world) world:bucket {}\n" +
                                     line + "\nend"));
        return process ? std::string("started") : to_sentence(process.error());
    };
    CHECK(sentence("story.wait(1)") ==
          "lesson.lua:4: story.wait belongs inside story(L, function() … end).");
    CHECK(sentence("story.wait_for 'caught'") ==
          "lesson.lua:4: story.wait_for belongs inside story(L, function() … end).");
    CHECK(sentence("story(function() end)") == "lesson.lua:4: write story(L, function() … end).");
}

TEST_CASE("story: waiting for what can't come is a mistake") {
    const LessonFolder folder;
    const auto sentence = [&](const std::string& rest) {
        auto process = folder.start(lesson_text(
            "local story = require 'story'\nfunction L:start(world)\n story(L, function()\n  "
            "story.wait_for 'caught'\n end)\n" +
            rest + "\nend"));
        return process ? std::string("started") : to_sentence(process.error());
    };
    CHECK(sentence("") ==
          "lesson.lua:5: nothing can be caught without world:bucket; put a bucket on the tool in "
          "L:start.");
    CHECK(sentence("world:bucket {}") == "started");  // declared further down
    Player player;
    player.start(
        "local story = require 'story'\nfunction L:start(world) story(L, function()\n "
        "story.wait(0.1) story.wait_for('landed', 'caught') end) end");
    player.step();
    CHECK(player.error ==
          "lesson.lua:4: nothing can be caught without world:bucket; put a bucket on the tool in "
          "L:start.");
}

TEST_CASE("motion: what it is given wrong is told at the hand's line, not the library's") {
    const auto sentence = [](const std::string& line) {
        Player player;
        player.folder.write(
            "hand.lua", "local motion = require 'motion'\nreturn motion.play(function(world)\n" +
                            line + "\nend)");
        player.start("function L:start(world) world:body { name = 'apple' } end", "hand.lua");
        player.step();
        return player.error;
    };
    CHECK(sentence("motion.moveto({ 0, 0, 0 }, 1)") ==
          "hand.lua:3: motion has no moveto; did you mean move_to?");
    CHECK(sentence("motion.wait()") == "hand.lua:3: motion.wait takes seconds; got nothing.");
    CHECK(sentence("motion.move_to({ 0, 1 }, 1)") ==
          "hand.lua:3: motion.move_to takes a place of three numbers, { x, y, z }; got { 0, 1, "
          "nothing }.");
    CHECK(sentence("motion.move_to(3, 1)") ==
          "hand.lua:3: motion.move_to takes a place, { x, y, z }, a body or the tool; got 3.");
    CHECK(sentence("motion.move_to({ 0, 1, 0 })") ==
          "hand.lua:3: motion.move_to's second value takes seconds; got nothing.");
    CHECK(sentence("motion.wait_until(true)") ==
          "hand.lua:3: motion.wait_until takes a function; got true.");
    CHECK(sentence("motion.follow 'apple'") ==
          "hand.lua:3: motion.follow takes a body; got the text \"apple\".");
    CHECK(sentence("motion.follow(world:find 'apple', { second = 3 })") ==
          "hand.lua:3: motion.follow has no second; did you mean seconds?");
    CHECK(sentence("motion.follow(world:find 'apple', { until_ = 3 })") ==
          "hand.lua:3: motion.follow's until_ is a function; got 3.");
    CHECK(sentence("motion.move_to({ 0, 0, -20000 }, 1)") ==
          "hand.lua:3: motion.move_to goes at most 10000 metres far along each axis; got -20000.");
    CHECK(sentence("motion.turn_to({ 0, 0, 4000 }, 1)") ==
          "hand.lua:3: motion.turn_to turns by at most 3600 degrees; got 4000.");
    CHECK(sentence("motion.turn_to(30, 1)") ==
          "hand.lua:3: motion.turn_to takes degrees about a direction, such as { 0, 0, 30 }; got "
          "30.");
    CHECK(sentence("motion.press(-1)") == "hand.lua:3: motion.press takes 0, 1, 2 or 3; got -1.");
    CHECK(sentence("motion.move_to(world:find 'apple', 1)") == "");
}

TEST_CASE("motion: moves with least jerk, waits, follows and presses") {
    Player player;
    player.folder.write("hand.lua", R"(
local motion = require "motion"
return motion.play(function(world)
  motion.wait(0.5)
  motion.move_to({ 0.4, 0.3, 0 }, 1)
  motion.press(2)
  motion.follow(world:find "apple", { seconds = 20, y = 0.2 })
  motion.press(0)
  motion.turn_to({ 0, 0, 30 }, 1)
end)
)");
    player.start("function L:start(world) world:body { name = 'apple', at = {-0.3, 1, 0.1} } end",
                 "hand.lua");
    std::vector<double> xs;
    for (int i = 0; i < 7; ++i) {
        player.step();
        REQUIRE(player.error == "");
        REQUIRE(player.last.has_hand_target);
        xs.push_back(player.last.hand_target_W.position.x());
    }
    // At 0, 0.25 and 0.5 s it waits; then 10 s^3 - 15 s^4 + 6 s^5 of 0.4 m at quarters: 0.1035, 0.5, 0.8965, 1.
    const std::vector<double> expected = {0,  0, 0, 0.4 * 0.103515625, 0.4 * 0.5, 0.4 * 0.896484375,
                                          0.4};
    for (std::size_t i = 0; i < xs.size(); ++i) {
        CHECK(xs[i] == Approx(expected[i]).margin(1e-12));
    }
    CHECK(player.last.hand_buttons == 2U);
    for (int i = 0; i < 79; ++i) {
        player.step();
    }
    CHECK((player.last.hand_target_W.position - Vector3(-0.3, 0.2, 0.1)).norm() < 1e-6);
    CHECK(player.last.hand_buttons == 2U);
    player.step();
    player.step();
    CHECK(player.last.hand_buttons == 0U);
    // It turns as it moves: half of it after two of four steps, all of it at the end.
    const auto find_turn_deg = [&] {
        const Quaternion& turned = player.last.hand_target_W.orientation;
        return 2.0 * std::atan2(turned.z(), turned.w()) * 180.0 / std::numbers::pi;
    };
    player.step();
    CHECK(find_turn_deg() == Approx(15.0));
    player.step();
    player.step();
    CHECK(find_turn_deg() == Approx(30.0));
}

TEST_CASE("motion: following covers the same share whatever the frame rate") {
    const auto distance_after = [](double dt_s) {
        Player player;
        player.folder.write("hand.lua",
                            "local motion = require 'motion'\nreturn motion.play(function(world) "
                            "motion.follow(world:find 'apple', { seconds = 9 }) end)");
        player.start("function L:start(world) world:body { name = 'apple', at = {1, 0.3, 0} } end",
                     "hand.lua");
        for (int i = 0; i <= std::lround(0.25 / dt_s); ++i) {
            player.step({}, dt_s);
        }
        return 1.0 - player.last.hand_target_W.position.x();
    };
    CHECK(distance_after(0.05) == Approx(std::exp(-12 * 0.25)));
    CHECK(distance_after(0.0125) == Approx(std::exp(-12 * 0.25)));
}

}  // namespace
}  // namespace fulcrum::runtime
