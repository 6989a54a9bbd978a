#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

std::string sentence(const std::string& in_start) {
    return HostedLesson().start(in_start);
}

TEST_CASE("api: the same thing is the same object, fit for == and as a key") {
    HostedLesson lesson;
    REQUIRE(lesson.start("local a = world:body { name = 'a' } local t = { [a] = 'mine' } "
                         "print(world:find('a') == a, world:bodies()[1] == a, t[world:find 'a'], "
                         "world:tool() == world:tool(), tostring(a), tostring(world))") == "");
    CHECK(lesson.prints == "true\ttrue\tmine\ttrue\ta\tworld;");
}

TEST_CASE("api: methods insist on their colon and their owner") {
    CHECK(sentence("world.caption('x')") ==
          "lesson.lua:2: write world:caption with a colon, after a world.");
    CHECK(sentence("local b = world:body { name = 'b' } world.caption(b, 'x')") ==
          "lesson.lua:2: write world:caption with a colon, after a world.");
    CHECK(sentence("local h = world:hand {} h.force(print)") ==
          "lesson.lua:2: write hand:force with a colon, after a hand.");
    CHECK(sentence("local h = world:hand {} h.force(world, print)") ==
          "lesson.lua:2: write hand:force with a colon, after a hand.");
    CHECK(HostedLesson().load("L.test({})") ==
          "lesson.lua:2: write L:test with a colon, after the lesson's own variable.");
}

TEST_CASE("api: unknown fields suggest the nearest; nothing can be set") {
    CHECK(sentence("local b = world:body { name = 'b' } print(b.wieght)") ==
          "lesson.lua:2: body has no \"wieght\"; did you mean \"weight\"?");
    CHECK(sentence("print(world:tool().flavour)") == "lesson.lua:2: tool has no \"flavour\".");
    // What another thing has is told with its place; a force was once the world's.
    CHECK(sentence("world:force(function(tool) return 0, 0, 0 end)") ==
          "lesson.lua:2: world has no \"force\"; write hand:force (world:hand gives the hand) or "
          "tool.force (world:tool gives the tool).");
    CHECK(sentence("world:hand {}:spring { at = { 0, 0, 0 }, stiffness = 1 }") ==
          "lesson.lua:2: hand has no \"spring\"; write world:spring.");
    CHECK(sentence("world:listen(print)") ==
          "lesson.lua:2: world has no \"listen\"; write L:listen.");
    CHECK(sentence("print(world.vx)") ==
          "lesson.lua:2: world has no \"vx\"; write tool.vx (world:tool gives the tool).");
    CHECK(sentence("world:hand {}.x = 3") ==
          "lesson.lua:2: hand.x can't be set; it shows how things stand.");
    CHECK(sentence("world.time = 3") ==
          "lesson.lua:2: world.time can't be set; it shows how things stand.");
}

TEST_CASE("api: each function has its time") {
    CHECK(sentence("L:question 'q' { prompt = '', answers = { 'a' }, right = print }") ==
          "lesson.lua:2: L:question stands outside all functions, so that it runs when the lesson "
          "is loaded.");
    HostedLesson lesson;
    REQUIRE(lesson.load("function L:start(world) self.world = world end function L:update() "
                        "self.world:gravity(1) end") == "");
    CHECK(lesson.play() ==
          "lesson.lua:2: world:gravity declares something; that is only possible in L:start.");
    CHECK(HostedLesson().load("L:listen(print)") ==
          "lesson.lua:2: L:listen needs the world; call it in L:start or later.");
}

TEST_CASE(
    "api: a lesson's function that is nearly a callback's is told; others are the teacher's own") {
    CHECK(HostedLesson().load("function L:cauhgt() end") ==
          "lesson.lua:2: nothing calls L:cauhgt; did you mean L:caught?");
    CHECK(HostedLesson().load(
              "function L:restart() end function L:weigh() end L.score = 3 L.keys = {}") == "");
}

TEST_CASE("api: a reply holds so many commands and no more") {
    HostedLesson lesson;
    REQUIRE(lesson.load("function L:update(world) for i = 1, 254 do world:score(i) end end") == "");
    CHECK(lesson.play() == "");
    CHECK(lesson.reply.commands.size() == 254);
    REQUIRE(lesson.load("function L:update(world) for i = 1, 255 do world:score(i) end end") == "");
    CHECK(lesson.play() == "lesson.lua:2: more than 256 commands in one frame.");
}

}  // namespace
}  // namespace fulcrum::runtime
