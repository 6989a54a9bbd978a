// Rigid bodies, as lessons declare, move and read them.
#include "runtime/lua/api/rigid_bodies.h"

#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

TEST_CASE("rigid bodies: one is solid and seen, with its size, shape and mass") {
    HostedLesson lesson;
    REQUIRE(lesson.start(
                "world:body { name = 'a', model = 'box', size = { 0.1, 0.2, 0.05 }, rigid = true, "
                "density = 600 }\n"
                "world:body { name = 'b', model = 'sphere', radius = 0.1, rigid = true, mass = 2, "
                "visible = false, shape = 'capsule' }\n"
                "world:body { name = 'c', model = 'box', solid = true, size = { 1, 0.1, 1 } }") ==
            "");
    const auto& bodies = lesson.host->description().bodies;
    REQUIRE(bodies[0].rigid);
    CHECK(bodies[0].solid);
    CHECK(bodies[0].visible);
    CHECK(bodies[0].size_m == Vector3(0.1, 0.2, 0.05));
    CHECK(bodies[0].mass_kg == Approx(0.6));
    CHECK(bodies[0].collides_as == RigidShape::model);
    REQUIRE(bodies[1].rigid);
    CHECK_FALSE(bodies[1].visible);
    CHECK(bodies[1].collides_as == RigidShape::capsule);
    CHECK_FALSE(bodies[1].rigid->joint);
    CHECK_FALSE(bodies[2].rigid);
    CHECK(box_size_m(bodies[2]) == Vector3(1, 0.1, 1));
    CHECK(box_size_m(bodies[1]) == Vector3::Constant(0.2));
}

TEST_CASE("rigid bodies: one is seen, felt and simulated as three models") {
    HostedLesson lesson;
    REQUIRE(lesson.start("world:body { name = 'vase', felt_model = 'sphere', simulated_model = "
                         "'box', size = { 0.1, 0.2, 0.1 }, density = 1000, rigid = true }\n"
                         "world:body { name = 'table', model = 'box', solid = true, "
                         "simulated_model = 'bucket', shape = 'mesh' }\n"
                         "world:body { name = 'egg', solid = true, felt_model = 'apple' }") == "");
    const auto& bodies = lesson.host->description().bodies;
    CHECK(bodies[0].model == "vase");
    CHECK(as_felt(bodies[0]).model == "sphere");
    CHECK(as_simulated(bodies[0]).model == "box");
    // The volume is that of what is simulated, the ball reaches as far as its longest edge.
    CHECK(bodies[0].mass_kg == Approx(2.0));
    CHECK(bodies[0].radius_m == Approx(0.1));
    CHECK(as_felt(bodies[1]).model == "box");
    CHECK(as_simulated(bodies[1]).model == "bucket");
    CHECK(bodies[1].collides_as == RigidShape::mesh);
    // What is not said is as what stands before it.
    CHECK(as_simulated(bodies[2]).model == "apple");
}

TEST_CASE("rigid bodies: a joint is in radians, or metres of a slider, from where the body is") {
    HostedLesson lesson;
    REQUIRE(
        lesson.start(
            "world:body { name = 'post', model = 'box', rigid = true }\n"
            "world:body { name = 'door', model = 'box', rigid = true, at = { 1, 0, 0 }, joint = { "
            "kind = 'hinge', to = 'post', axis = { 0, 1, 0 }, lowest = -90, highest = 45, speed = "
            "180, force = 2, friction = 0.1 } }\n"
            "world:body { name = 'drawer', model = 'box', rigid = true, joint = { kind = "
            "'slider', at = { 0, 1, 0 }, highest = 0.3 } }\n"
            "world:body { name = 'bob', model = 'box', rigid = true, joint = { kind = 'rod', at "
            "= { 0, 2, 0 } } }") == "");
    const auto& bodies = lesson.host->description().bodies;
    REQUIRE(bodies[1].rigid->joint);
    const JointDescription& door = *bodies[1].rigid->joint;
    CHECK(door.kind == JointKind::hinge);
    CHECK(door.to == "post");
    CHECK(door.at_W == Vector3(1, 0, 0));
    CHECK(door.axis_W == Vector3::UnitY());
    CHECK(door.lowest == Approx(-0.5 * std::numbers::pi));
    CHECK(door.highest == Approx(0.25 * std::numbers::pi));
    CHECK(door.speed == Approx(std::numbers::pi));
    CHECK(door.force == 2.0);
    CHECK(door.friction == 0.1);
    REQUIRE(bodies[2].rigid->joint);
    CHECK(bodies[2].rigid->joint->highest == 0.3);
    CHECK(bodies[2].rigid->joint->lowest == -kAnyTravel);
    REQUIRE(bodies[3].rigid->joint);
    CHECK(bodies[3].rigid->joint->kind == JointKind::distance);
    CHECK(bodies[3].rigid->joint->at_W == Vector3(0, 2, 0));
    CHECK(bodies[3].rigid->joint->other_at_W == Vector3::Zero());
}

TEST_CASE("rigid bodies: a lesson puts, drops and hides them, and reads how they lie") {
    HostedLesson lesson;
    REQUIRE(
        lesson.load("local b function L:start(world) b = world:body { name = 'b', model = 'box', "
                    "rigid = true } end\n"
                    "function L:update() b:place { at = { 1, 0, 0 } } b:drop { at = { 2, 0, 0 } "
                    "} b:hide() assert(b.speed == 0 and not b.resting and b.tilt == 0 and "
                    "b.velocity.x == 0) end") == "");
    REQUIRE(lesson.play() == "");
    CHECK(lesson.commands<MoveCommand>().size() == 3);
    HostedLesson holds;
    REQUIRE(
        holds.load("local b function L:start(world) b = world:body { name = 'b', model = 'box', "
                   "rigid = true } end\n"
                   "function L:update() b:hold() end") == "");
    CHECK_THAT(holds.play(), Catch::Contains("grips it with the button"));
}

TEST_CASE("bodies of boxes: they are where they are said to be") {
    HostedLesson lesson;
    REQUIRE(lesson.start("world:body { name = 'house', model = 'box', solid = true, at = { 1, 0, 0 "
                         "}, boxes = {\n"
                         "  { at = { 0, 0.1, 0 }, size = { 0.4, 0.2, 0.02 } }, { at = { 0.3, 0.1, "
                         "0 }, size = { 0.02, 0.2, "
                         "0.4 } } } }") == "");
    const BodyDescription& house = lesson.host->description().bodies.at(0);
    REQUIRE(house.boxes.size() == 2);
    CHECK(house.boxes[0] == PlacedBox{Vector3(0.0, 0.1, 0.0), Vector3(0.4, 0.2, 0.02)});
    CHECK(house.boxes[1].at_B == Vector3(0.3, 0.1, 0.0));
    CHECK(house.radius_m == Approx(0.31));
}

}  // namespace
}  // namespace fulcrum::runtime
