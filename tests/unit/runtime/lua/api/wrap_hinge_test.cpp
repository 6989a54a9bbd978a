// Bodies on hinges, as lessons declare, turn and read them.
#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

constexpr double kDegree_rad = std::numbers::pi / 180.0;

TEST_CASE("hinges: a declared hinge is in the description, in radians and the body's own metres") {
    HostedLesson lesson;
    REQUIRE(lesson.start("world:body { name = 'lever', solid = true, at = { 1, 2, 0 }, hinge = { "
                         "axis = { 0, 0, 0.5 }, at = { 1.5, 2, 0 }, inertia = 0.5, friction = 0.1, "
                         "lowest = -90, highest = 180, load = 3, load_at = { 0, 2, 0 } } }\n"
                         "world:body { name = 'globe', solid = true, hinge = { axis = { 0, 0, 1 }, "
                         "inertia = 2 } }\n"
                         "world:body { name = 'rock' }") == "");
    const auto& bodies = lesson.host->description().bodies;
    REQUIRE(bodies[0].hinge);
    const AxleSettings& hinge = *bodies[0].hinge;
    CHECK((hinge.axis_W - Vector3::UnitZ()).norm() < 1e-15);
    CHECK((hinge.pivot_B - Vector3(0.5, 0, 0)).norm() < 1e-15);
    CHECK((hinge.load_B - Vector3(-1, 0, 0)).norm() < 1e-15);
    CHECK(hinge.inertia_kg_m2 == 0.5);
    CHECK(hinge.friction_Nm == 0.1);
    CHECK(hinge.lowest_rad == Approx(-0.5 * std::numbers::pi));
    CHECK(hinge.highest_rad == Approx(std::numbers::pi));
    CHECK(hinge.load_N == 3.0);
    REQUIRE(bodies[1].hinge);
    CHECK(bodies[1].hinge->highest_rad == kAnyAngle_rad);
    CHECK(bodies[1].hinge->pivot_B == Vector3::Zero());
    CHECK_FALSE(bodies[2].hinge);
}

TEST_CASE("hinges: a turn orders what it is given and nothing else") {
    HostedLesson lesson;
    REQUIRE(
        lesson.load("local b function L:start(world) world:body { name = 'a' } b = world:body { "
                    "name = 'b', solid = true, hinge = { axis = { 0, 0, 1 }, inertia = 1 } } end\n"
                    "function L:update() b:turn { angle = 90, spin = -180 } b:turn { at = { 1, "
                    "0, 0 }, load = 4 } end") == "");
    REQUIRE(lesson.play() == "");
    const auto turns = lesson.commands<TurnCommand>();
    REQUIRE(turns.size() == 2);
    CHECK(turns[0].body == 1);
    CHECK(turns[0].angle_rad.value_or(0) == Approx(0.5 * std::numbers::pi));
    CHECK(turns[0].spin_rad_per_s.value_or(0) == Approx(-std::numbers::pi));
    CHECK_FALSE(turns[0].pivot_W);
    CHECK_FALSE(turns[0].load_N);
    CHECK_FALSE(turns[1].angle_rad);
    CHECK(turns[1].pivot_W.value_or(Vector3::Zero()) == Vector3(1, 0, 0));
    CHECK(turns[1].load_N.value_or(0) == 4.0);
}

TEST_CASE("hinges: fields tell how each one stands, in degrees") {
    HostedLesson lesson;
    REQUIRE(
        lesson.load(
            "local a, b function L:start(world) a = world:body { name = 'a', solid = true, hinge "
            "= { axis = { 0, 1, 0 }, inertia = 0.25 } } world:body { name = 'c' } b = world:body { "
            "name = 'b', solid "
            "= true, hinge = { axis = { 0, 0, 1 }, inertia = 1 } } print(a.angle, a.arm) end\n"
            "function L:update() print(a.angle, a.spin, a.inertia) print(b.torque, b.arm, "
            "b.load_torque) end") == "");
    CHECK(lesson.prints == "0.0\t0.0;");
    lesson.prints.clear();
    LessonFrame frame = lesson.frame();
    frame.hinges = {{45 * kDegree_rad, -10 * kDegree_rad, 0, 0, 0}, {0, 0, -0.5, 0.25, 0.75}};
    REQUIRE(lesson.play(frame) == "");
    CHECK(lesson.prints == "45.0\t-10.0\t0.25;-0.5\t0.25\t0.75;");
    // On another pivot it is harder to turn.
    lesson.prints.clear();
    frame.hinges[0].inertia_kg_m2 = 0.75;
    REQUIRE(lesson.play(frame) == "");
    CHECK(lesson.prints == "45.0\t-10.0\t0.75;-0.5\t0.25\t0.75;");
}

TEST_CASE("world: the day is known once the lesson runs") {
    HostedLesson lesson;
    REQUIRE(lesson.load("function L:update(world) print(world.day) end") == "");
    ReadyEvent ready;
    ready.day = 9669.5;
    REQUIRE(lesson.play(lesson.frame({ready})) == "");
    CHECK(lesson.prints == "9669.5;");
}

}  // namespace
}  // namespace fulcrum::runtime
