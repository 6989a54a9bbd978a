#include "runtime/lua/api/sound_names.h"

#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

/// "name@line " of each sound found.
std::string found(std::string_view text) {
    std::string all;
    for (const SoundUse& use : find_sounds(text)) {
        all += use.name + '@' + std::to_string(use.line) + ' ';
    }
    return all;
}

TEST_CASE("sound names: found with their lines, however the call is written") {
    CHECK(found("world:sound \"pop\"\n  world:sound('ding')\nself.world:sound( \"x\" )") ==
          "pop@1 ding@2 x@3 ");
    CHECK(found("world:sound \"pop\" world:sound \"pop\"") == "pop@1 pop@1 ");
}

TEST_CASE("sound names: comments, texts, other objects and computed names are left alone") {
    CHECK(found("-- world:sound 'a'\n--[[ world:sound 'b'\n]] --[==[ world:sound 'c' ]] ]==]") ==
          "");
    CHECK(
        found(
            "print \"world:sound 'a'\" print [[world:sound 'b']] x = 'it\\'s world:sound \"c\"'") ==
        "");
    CHECK(found("world:sound(name) bell:sound 'a' myworld:sound 'b' world:sound('catch_' .. n)") ==
          "");
    CHECK(found("a = b[c] world:sound 'after'\n--[ one line\nworld:sound 'two'") ==
          "after@1 two@3 ");
    CHECK(found("world:sound '") == "@1 ");
    CHECK(found("world:sound 'open\\").size() > 0);
    CHECK(found("[[ never closed world:sound 'a'") == "");
    CHECK(found("").empty());
}

TEST_CASE("sound names: an unknown one is told before the lesson plays, or when it is computed") {
    HostedLesson lesson;
    CHECK(lesson.load("\nfunction L:key() world:sound 'pup' end") ==
          "lesson.lua:3: there is no sound \"pup\"; did you mean \"pop\"?");
    CHECK(
        lesson.load("function L:update(world)\n world:sound('bell') end") ==
        "lesson.lua:3: there is no sound \"bell\"; the sounds are catch, catch_watermelon, "
        "catch_apple, catch_banana, catch_egg, landed, splat, right, try_again, level_up, finish, "
        "pop, click.");
    REQUIRE(lesson.load("local n = 'clik' function L:update(world) world:sound(n) end") == "");
    CHECK(lesson.play() == "lesson.lua:2: there is no sound \"clik\"; did you mean \"click\"?");
}

}  // namespace
}  // namespace fulcrum::runtime
