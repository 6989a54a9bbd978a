#include "haptics/dynamics/axle.h"
#include "runtime/lua/api/rigid_bodies.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>

using namespace fulcrum::runtime::test;

namespace {

using Kind = WorldCommand::Kind;

constexpr double kDegree_rad = std::numbers::pi / 180.0;

}  // namespace

TEST_CASE("hinge place: the reference says how far one may be") {
    std::ostringstream limit;
    limit << "at most " << kFarthestOnAxle_m << " m from ";
    std::size_t n_told = 0;
    for (const Binding& binding : api_table().functions) {
        for (const Parameter& parameter : binding.parameters) {
            n_told += std::string(parameter.text).find(limit.str()) != std::string::npos ? 1 : 0;
            for (std::size_t i = 0; i < parameter.n_fields; ++i) {
                n_told +=
                    std::string(parameter.fields[i].text).find(limit.str()) != std::string::npos
                        ? 1
                        : 0;
            }
        }
    }
    CHECK(n_told == 3);
}

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

TEST_CASE("bodies: before the first frame they stand as declared, with no felt weight known") {
    HostedLesson lesson;
    REQUIRE(lesson.start("local a = world:body { name = 'a', visible = true, at = { 1, 2, 3 } } "
                         "local b = world:body { name = 'b' } print(a.where, a.y, b.where)") == "");
    CHECK(lesson.prints == "placed\t2.0\thidden;");
    CHECK(HostedLesson().start("print(world:body { name = 'a' }.felt_weight)") ==
          "lesson.lua:2: body.felt_weight is known once the lesson runs, in L:update and later, "
          "not in L:start.");
}

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
