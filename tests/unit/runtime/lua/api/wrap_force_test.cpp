#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

TEST_CASE("forces: each change is sent whole, with what was changed before") {
    HostedLesson lesson;
    REQUIRE(lesson.load("local s, m function L:start(world) s = world:spring { name = 's', at = { "
                        "1, 2, 3 }, stiffness = 5 } "
                        "m = world:magnet { at = { 0, 0, 0 }, force = 2 } end\n"
                        "function L:update() s:off() s:strength(0.25) s:move { at = { 4, 5, 6 } } "
                        "s:on() m:strength(0) print(s.name, m.name) end") == "");
    REQUIRE(lesson.play() == "");
    const auto changes = lesson.commands<FieldChangeCommand>();
    REQUIRE(changes.size() == 5);
    CHECK(changes[0].force == 0);
    CHECK_FALSE(changes[0].field.on);
    CHECK(changes[0].field.anchor_W == Vector3(1, 2, 3));
    CHECK(changes[0].field.strength == 1.0);
    CHECK(changes[1].field.strength == 0.25);
    CHECK_FALSE(changes[1].field.on);
    CHECK(changes[2].field.anchor_W == Vector3(4, 5, 6));
    CHECK(changes[3].field.on);
    CHECK(changes[3].field.anchor_W == Vector3(4, 5, 6));
    CHECK(changes[4].force == 1);
    CHECK(changes[4].field.strength == 0.0);
    CHECK(lesson.prints == "s\tmagnet1;");
}

}  // namespace
}  // namespace fulcrum::runtime
