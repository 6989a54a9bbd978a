// The modules of scripts/lib, run in a lesson as teachers use them.
#include "tests/unit/runtime/lua/lesson_player.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>

using namespace fulcrum::runtime::test;

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

TEST_CASE("story: asks, waits for a condition, beside another and the lesson's own functions") {
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

TEST_CASE(
    "story: who does nothing is told, then shown by the program's own hand, and then it goes on") {
    Player player;
    player.start(std::string(kStory) + R"(
    print(story.wait_with_help(world, function() return self.done end, {
      hint = "Press here.", show = { { 0, 0.3, 0 }, { 0.2, 0.1, 0 } } }))
    print(story.wait_with_help(world, function() return self.done end, { hint = "Again.", seconds = 1 }))
  end)
end
function L:key(name) self.done = name == "down" end)");
    // What was said and shown first, and when.
    constexpr double kStep_s = 0.25;
    double said_s = -1.0;
    double shown_s = -1.0;
    double hidden_s = -1.0;
    Vector3 low{0.0, 9.0, 0.0};
    Vector3 high{0.0, -9.0, 0.0};
    for (double now_s = 0.0; now_s < 70.0 && player.prints.empty(); now_s += kStep_s) {
        player.step({}, kStep_s);
        for (const LessonCommand& command : player.last.commands) {
            if (std::holds_alternative<CaptionCommand>(command) && said_s < 0.0) {
                CHECK(std::get<CaptionCommand>(command).text == "Press here.");
                said_s = now_s;
            } else if (const auto* hand = std::get_if<ShowHandCommand>(&command)) {
                (hand->at_W ? shown_s : hidden_s) = shown_s < 0.0 || !hand->at_W ? now_s : shown_s;
                low = hand->at_W && hand->at_W->y() < low.y() ? *hand->at_W : low;
                high = hand->at_W && hand->at_W->y() > high.y() ? *hand->at_W : high;
            }
        }
    }
    CHECK(player.prints == "false;");
    CHECK(said_s == Approx(20.0).margin(2.0 * kStep_s));
    CHECK(shown_s == Approx(40.0).margin(2.0 * kStep_s));
    CHECK(hidden_s == Approx(60.0).margin(2.0 * kStep_s));
    CHECK((low - Vector3(0.2, 0.1, 0.0)).norm() < 1e-9);
    CHECK((high - Vector3(0.0, 0.3, 0.0)).norm() < 1e-9);
    player.step({KeyEvent{"down"}});
    player.step();
    CHECK(player.prints == "false;true;");
}

TEST_CASE(
    "story: who let the help go by is helped after half the time, then a quarter, until something "
    "is done") {
    Player player;
    player.start(std::string(kStory) + R"(
    local function take() local done = self.done self.done = false return done end
    for i = 1, 6 do print(story.wait_with_help(world, take, { hint = "Press here." })) end
  end)
end
function L:key(name) self.done = name == "down" end)");
    constexpr double kStep_s = 0.25;
    // Nothing is done three times, then something, and then nothing again.
    for (const double whole_s : {60.0, 30.0, 15.0, 15.0}) {
        player.prints.clear();
        double now_s = 0.0;
        for (; now_s < 70.0 && player.prints.empty(); now_s += kStep_s) {
            player.step({}, kStep_s);
        }
        CHECK(player.prints == "false;");
        CHECK(now_s == Approx(whole_s).margin(2.0 * kStep_s));
    }
    player.prints.clear();
    player.step({KeyEvent{"down"}}, kStep_s);
    player.step({}, kStep_s);
    REQUIRE(player.prints == "true;");
    double now_s = 0.0;
    for (; now_s < 70.0 && player.prints == "true;"; now_s += kStep_s) {
        player.step({}, kStep_s);
    }
    CHECK(now_s == Approx(60.0).margin(2.0 * kStep_s));
}

TEST_CASE("story: waiting for what can't come is a mistake") {
    Player player;
    player.start(
        "local story = require 'story'\nfunction L:start(world) story(L, function()\n "
        "story.wait(0.1) story.wait_for('landed', 'caught') end) end");
    player.step();
    CHECK(player.error ==
          "lesson.lua:4: nothing can be caught without world:bucket; put a bucket on the tool in "
          "L:start.");
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
