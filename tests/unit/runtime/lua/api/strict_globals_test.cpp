// Reading what nobody assigned.
#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

TEST_CASE("strict globals: what was assigned may be read, even nil") {
    HostedLesson lesson;
    CHECK(lesson.load("best = nil print(best) best = 3 print(best) best = nil print(best, _G[1])\n"
                      "function L:start() print(later()) end\nfunction later() return 'late' end\n"
                      "print(rawget(_G, 'never'))") == "");
    CHECK(lesson.prints == "nil;3;nil\tnil;nil;late;");
}

TEST_CASE("strict globals: a simulated hand's are strict too") {
    HostedLesson lesson;
    REQUIRE(lesson.load("", "return function(hand)\n return hnd.x, 0, 0 end") == "");
    CHECK(lesson.play() == "hand.lua:2: hnd has no value; did you mean hand?");
}

}  // namespace
}  // namespace fulcrum::runtime
