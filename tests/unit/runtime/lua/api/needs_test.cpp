// What one part of a lesson needs of another.
#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

constexpr const char* kStays =
    "sign stays as it is, for no body of this lesson is movable; declare it with movable = true.";

TEST_CASE("needs: L:caught without a bucket is told at the function") {
    CHECK(HostedLesson().load("\nfunction L:caught(body) end") ==
          "lesson.lua:3: L:caught is never called: nothing can be caught without world:bucket; put "
          "a bucket on the tool in L:start.");
    CHECK(HostedLesson().load("function L:caught() end function L:start(w) w:bucket {} end") == "");
}

TEST_CASE(
    "needs: place and hide in a scene where nothing moves are told, unless that comes later") {
    HostedLesson lesson;
    CHECK(lesson.start("local s = world:body { name = 'sign', visible = true }\n s:hide()") ==
          std::string("lesson.lua:3: ") + kStays);
    CHECK(lesson.start("local s = world:body { name = 'sign' }\n\n s:place { at = { 0, 1, 0 } }") ==
          std::string("lesson.lua:4: ") + kStays);
    CHECK(lesson.start("local s = world:body { name = 'sign' } s:hide() "
                       "world:body { name = 'apple', movable = true }") == "");
    REQUIRE(lesson.load("local s function L:start(w) s = w:body { name = 'sign' } end\n"
                        "function L:update() s:hide() end") == "");
    CHECK(lesson.play() == std::string("lesson.lua:3: ") + kStays);
}

}  // namespace
}  // namespace fulcrum::runtime
