#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;
using Kind = WorldCommand::Kind;

TEST_CASE("bodies: moves carry body, place and velocity; where it is now is the default") {
    HostedLesson lesson;
    REQUIRE(lesson.load(
                "local a, b function L:start(world) a = world:body { name = 'a' } b = world:body { "
                "name = 'b', movable = true, at = { 0, 1, 0 } } end\n"
                "function L:update(world) b:drop() b:drop { at = { 1, 2, 3 }, velocity = { 4, 5, 6 "
                "} } a:place { at = { 7, 8, 9 } } b:hold() a:hide() world:release() end") == "");
    LessonFrame frame = lesson.frame();
    frame.bodies[1].pose_W.position = Vector3(0, 0.5, 0);
    REQUIRE(lesson.play(frame) == "");
    const auto moves = lesson.commands<MoveCommand>();
    REQUIRE(moves.size() == 6);
    CHECK((moves[0].move.kind == Kind::drop && moves[0].move.body == 1));
    CHECK(moves[0].move.position_W == Vector3(0, 0.5, 0));
    CHECK(moves[0].move.velocity_W == Vector3::Zero());
    CHECK(moves[1].move.position_W == Vector3(1, 2, 3));
    CHECK(moves[1].move.velocity_W == Vector3(4, 5, 6));
    CHECK((moves[2].move.kind == Kind::place && moves[2].move.body == 0));
    CHECK(moves[2].move.position_W == Vector3(7, 8, 9));
    CHECK((moves[3].move.kind == Kind::hold && moves[3].move.body == 1));
    CHECK((moves[4].move.kind == Kind::hide && moves[4].move.body == 0));
    CHECK((moves[5].move.kind == Kind::release && moves[5].move.body == kNoBody));
    // Farther away than a lesson may say it is put as far as that.
    frame.bodies[1].pose_W.position = Vector3(3.0, 2.0e4, -1.1e4);
    REQUIRE(lesson.play(frame) == "");
    CHECK(lesson.commands<MoveCommand>().at(0).move.position_W == Vector3(3.0, 1.0e4, -1.0e4));
}

TEST_CASE("bodies: fields tell how things stand") {
    HostedLesson lesson;
    REQUIRE(
        lesson.load(
            "local a function L:start(world) world:gravity(2) a = world:body { name = 'a', noun = "
            "'pear', mass = 3, visible = true, at = { 1, 2, 3 } } print(a.where, a.x) end\n"
            "function L:update() local p = a.position print(a.name, a.noun, a.mass, a.weight, "
            "a.felt_weight, a.where, a.x, a.y, a.z, p[1] == p.x, p.y, p[3]) end") == "");
    LessonFrame frame = lesson.frame({ReadyEvent{{5.5}, 1.0}});
    for (const auto& [where, name] : {std::pair{BodyWhere::hidden, "hidden"},
                                      {BodyWhere::placed, "placed"},
                                      {BodyWhere::falling, "falling"},
                                      {BodyWhere::held, "held"},
                                      {BodyWhere::landed, "landed"}}) {
        frame.bodies[0].where = where;
        lesson.prints.clear();
        REQUIRE(lesson.play(frame) == "");
        CHECK(lesson.prints ==
              std::string("a\tpear\t3.0\t6.0\t5.5\t") + name + "\t1.0\t2.0\t3.0\ttrue\t2.0\t3.0;");
    }
}

TEST_CASE(
    "bodies: before the first frame they stand as declared, and the felt weight is not known") {
    HostedLesson lesson;
    REQUIRE(lesson.start("local a = world:body { name = 'a', visible = true, at = { 1, 2, 3 } } "
                         "local b = world:body { name = 'b' } print(a.where, a.y, b.where)") == "");
    CHECK(lesson.prints == "placed\t2.0\thidden;");
    CHECK(HostedLesson().start("print(world:body { name = 'a' }.felt_weight)") ==
          "lesson.lua:2: body.felt_weight is known once the lesson runs, in L:update and later, "
          "not in L:start.");
}

}  // namespace
}  // namespace fulcrum::runtime
