// Reading what nobody assigned.
#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

std::string sentence_of(const std::string& body) {
    return HostedLesson().load(body);
}

TEST_CASE("strict globals: a name that nobody gave a value is told where it is read") {
    CHECK(sentence_of("\nlocal t = { xyzzy }") ==
          "lesson.lua:3: xyzzy has no value; is it spelt right, or a text without its \"…\"?");
    CHECK(sentence_of("local all = {} for _, b in ipairs { all, plugh } do end") ==
          "lesson.lua:2: plugh has no value; is it spelt right, or a text without its \"…\"?");
    CHECK(sentence_of("function L:start(world) wrold:gravity(1) end") ==
          "lesson.lua:2: wrold has no value; did you mean world?");
}

TEST_CASE("strict globals: locals, captured names and globals are thought of") {
    CHECK(sentence_of("local book = 1 local x = bok") ==
          "lesson.lua:2: bok has no value; did you mean book?");
    CHECK(sentence_of("local stones = 1 function L:start() print(stones, stonse) end") ==
          "lesson.lua:2: stonse has no value; did you mean stones?");
    CHECK(sentence_of("prnit 'x'") == "lesson.lua:2: prnit has no value; did you mean print?");
}

TEST_CASE("strict globals: a name that belongs behind another is told where it belongs") {
    CHECK(sentence_of("question 'a' {}") ==
          "lesson.lua:2: question has no value; write L:question.");
    CHECK(sentence_of("function L:start() caption 'a' end") ==
          "lesson.lua:2: caption has no value; write world:caption.");
    CHECK(sentence_of("wait(3)") ==
          "lesson.lua:2: wait has no value; write story.wait, after local story = require "
          "\"story\".");
    CHECK(sentence_of("world:ground(0)") ==
          "lesson.lua:2: world has no value; it is given to functions such as function "
          "L:start(world).");
    CHECK(sentence_of("local caption = print caption 'a'") == "");
}

TEST_CASE("strict globals: a lesson's function that is not the lesson's is called by nobody") {
    CHECK(sentence_of("function start(world) end") ==
          "lesson.lua:2: nothing calls start; write function L:start(…).");
    CHECK(sentence_of("local function start() end start() touched = 3") == "");
}

TEST_CASE("strict globals: what was assigned may be read, even nil") {
    HostedLesson lesson;
    CHECK(lesson.load("best = nil print(best) best = 3 print(best) best = nil print(best, _G[1])\n"
                      "function L:start() print(later()) end\nfunction later() return 'late' end\n"
                      "print(rawget(_G, 'never'))") == "");
    CHECK(lesson.prints == "nil;3;nil\tnil;nil;late;");
}

TEST_CASE("strict globals: what plain Lua has and a lesson has not is explained") {
    CHECK(sentence_of("io.open('x')") ==
          "lesson.lua:2: a lesson has no files; keep words and numbers in the lesson itself.");
    CHECK(sentence_of("print(os.time())") ==
          "lesson.lua:2: a lesson has no operating system; world.time tells the seconds since it "
          "began.");
    CHECK(
        sentence_of("load 'x = 1'") ==
        "lesson.lua:2: a lesson runs no texts; write functions, or a module beside the lesson and "
        "require it.");
    CHECK(sentence_of("io = { open = print } io.open 'mine'") == "");
}

TEST_CASE("strict globals: the rule can't be taken off") {
    CHECK(sentence_of("setmetatable(_G, {})") ==
          "lesson.lua:2: this table's metatable is protected.");
    CHECK(sentence_of("print(getmetatable(_G)) local t = setmetatable({}, { __index = _G }) "
                      "print(t.xyzzy)") ==
          "lesson.lua:2: xyzzy has no value; is it spelt right, or a text without its \"…\"?");
}

TEST_CASE("strict globals: a simulated hand's are strict too") {
    HostedLesson lesson;
    REQUIRE(lesson.load("", "return function(hand)\n return hnd.x, 0, 0 end") == "");
    CHECK(lesson.play() == "hand.lua:2: hnd has no value; did you mean hand?");
}

}  // namespace
}  // namespace fulcrum::runtime
