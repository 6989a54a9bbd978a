// What a hand holds all the time among rigid bodies, and what lies in it.
#include "haptics/geometry/shape.h"
#include "tests/unit/haptics/dynamics/rigid_loop_fixture.h"

#include <cmath>

namespace fulcrum {
namespace {

// A bucket that hangs still 0.5 m above the ground, and two balls: the scene's 3 and 5.
RigidLoopPlan make_bucket() {
    RigidLoopPlan plan = make_two_cubes();
    const auto cup = make_cup(0.1, 0.08, 0.12, 0.01, 16).and_then([](const TriangleMesh& mesh) {
        return CollisionMesh::create(mesh);
    });
    for (int i : {1, 2}) {
        plan.world.bodies[static_cast<std::size_t>(i)].shape = SphereShape{0.03};
        plan.world.bodies[static_cast<std::size_t>(i)].pose_W.position = {i - 3.0, 0.03, 0.0};
    }
    plan.carrier = 3;
    plan.world.bodies.push_back(
        {.shape = *cup, .mass_kg = 0.1, .pose_W = Pose::at({0.0, 0.5, 0.0})});
    plan.world.joints = {
        {.kind = JointKind::fixed, .body_b = 3, .anchor_W = Vector3(0.0, 0.5, 0.0)}};
    plan.scene_bodies.push_back(kNoBody);
    plan.solids.push_back(3);
    return plan;
}

TEST_CASE(
    "rigid loop: what falls into the carrier is caught once, with its speed, and lies there") {
    CubesLoop balls(make_bucket());
    balls.run(0.1);
    // From 0.3 m above where its centre stops, 0.35 m above the rim.
    balls.order(WorldCommand::Kind::drop, 3, {0.0, 0.71, 0.0});
    balls.run(1.5);
    auto told = balls.events();
    REQUIRE(told.size() == 1);
    CHECK(told[0].kind == WorldEvent::Kind::caught);
    CHECK(told[0].body == 3);
    CHECK(told[0].speed_m_per_s == Approx(std::sqrt(2.0 * 9.81 * 0.3)).epsilon(0.02));
    CHECK(balls.seen(3).where == BodyWhere::held);
    CHECK(balls.seen(3).pose_W.position.y() == Approx(0.41).margin(1.0e-3));
    CHECK(balls.seen(5).where == BodyWhere::landed);
    // One upon the other is caught as well, and has not landed though it meets a ball first.
    balls.order(WorldCommand::Kind::drop, 5, {0.02, 0.71, 0.0});
    balls.run(1.5);
    told = balls.events();
    REQUIRE(told.size() == 1);
    CHECK(told[0].kind == WorldEvent::Kind::caught);
    CHECK(told[0].body == 5);
    // All are let go; what is put back outside has landed there.
    balls.order(WorldCommand::Kind::release, kNoBody, Vector3::Zero());
    balls.run(0.1);
    CHECK(balls.seen(3).where == BodyWhere::hidden);
    CHECK(balls.seen(5).where == BodyWhere::hidden);
    balls.order(WorldCommand::Kind::drop, 3, {0.5, 0.3, 0.0});
    balls.run(1.0);
    told = balls.events();
    REQUIRE(told.size() == 1);
    CHECK(told[0].kind == WorldEvent::Kind::landed);
    CHECK(balls.seen(3).where == BodyWhere::landed);
}

TEST_CASE("rigid loop: what the carrier leans against from outside is not caught") {
    // A cube upon another one, and a hand that presses the bucket's wall against it.
    RigidLoopPlan plan = make_bucket();
    plan.world.bodies[1] = plan_cube(0.05, {0.0, 0.05, 0.0}, 0.5);
    plan.world.bodies[2] = plan_cube(0.05, {0.0, 0.15, 0.0}, 0.5);
    const Vector3 beside_W(0.157, 0.25, 0.0);
    plan.world.bodies[3].pose_W = Pose::at(beside_W);
    plan.world.joints.clear();
    CubesLoop cubes(plan);
    RigidPush hold = make_push(beside_W, beside_W, {-4.5, 0.1 * 9.81, 0.0});
    hold.solid = 3;
    hold.hold.slopes = {.stiffness_N_per_m = 500.0,
                        .damping_Ns_per_m = 10.0,
                        .turn_stiffness_Nm_per_rad = 5.0,
                        .turn_damping_Nms_per_rad = 0.1};
    for (int i = 0; i < 50; ++i) {
        cubes.push({hold});
        cubes.run(0.01);
    }
    // It would be 9 mm nearer were nothing in its way.
    CHECK(cubes.felt(3).pose_W.position.x() > beside_W.x() - 0.005);
    CHECK(cubes.seen(5).where != BodyWhere::held);
    CHECK(cubes.events().empty());
}

// A ball that was caught, and is thrown up for so long with twice its weight.
void throw_up(CubesLoop& balls, double seconds) {
    balls.order(WorldCommand::Kind::drop, 5, {0.0, 0.5, 0.0});
    balls.run(1.0);
    REQUIRE(balls.events().size() == 1);
    const Vector3 at_W = balls.seen(5).pose_W.position;
    RigidPush kick = make_push(at_W, at_W, {0.0, 9.0, 0.0});
    kick.n_placements = balls.felt(2).n_placements;
    balls.push({kick});
    balls.run(seconds);
    balls.push({});
}

TEST_CASE("rigid loop: what is caught is let go as well while it bounces") {
    CubesLoop balls(make_bucket());
    throw_up(balls, 0.04);
    balls.run(0.02);
    REQUIRE(balls.seen(5).velocity_W.norm() > 0.05);
    REQUIRE(balls.seen(5).where == BodyWhere::held);
    balls.order(WorldCommand::Kind::release, kNoBody, Vector3::Zero());
    balls.run(0.002);
    CHECK(balls.seen(5).where == BodyWhere::hidden);
}

TEST_CASE("rigid loop: what bounces beneath the rim is caught once, and lands nowhere") {
    CubesLoop balls(make_bucket());
    throw_up(balls, 0.09);
    // Six centimetres high, and a quarter of a second in the air.
    balls.run(0.08);
    CHECK(balls.seen(5).pose_W.position.y() > 0.47);
    balls.run(0.8);
    CHECK(balls.events().empty());
    CHECK(balls.seen(5).where == BodyWhere::held);
}

TEST_CASE(
    "rigid loop: a hand puts what it holds where it is, once, and by no number that is none") {
    CubesLoop cubes;
    cubes.run(0.1);
    RigidPush put = make_push({2.0, 0.5, 1.0}, Vector3::Zero(), Vector3::Zero());
    put.puts = true;
    cubes.push({put});
    cubes.run(0.003);
    CHECK(cubes.felt(2).n_placements == 1);
    CHECK((cubes.felt(2).pose_W.position - Vector3(2.0, 0.5, 1.0)).norm() < 1.0e-3);
    put.n_placements = 1;
    put.pose_W.position.x() = std::nan("");
    cubes.push({put});
    cubes.run(0.003);
    CHECK(cubes.felt(2).n_placements == 1);
    RigidLoopPlan plan = make_two_cubes();
    plan.carrier = 3;
    CHECK_FALSE(validate(plan));
}

}  // namespace
}  // namespace fulcrum
