#include "haptics/dynamics/rigid_world.h"

#include "haptics/geometry/shape.h"
#include "tests/support/rigid_worlds.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kStep_s = 1.0e-3;
constexpr double kGravity = 9.81;

RigidBodyPlan make_ground(double friction = 0.6) {
    return {.role = BodyRole::ground, .static_friction = friction, .dynamic_friction = friction};
}

RigidBodyPlan make_cube(const Vector3& at, double mass_kg = 1.0) {
    return {.shape = BoxShape{Vector3::Constant(0.05)}, .mass_kg = mass_kg, .pose_W = Pose::at(at)};
}

std::unique_ptr<RigidWorld> make_world(RigidWorldPlan plan) {
    auto world = RigidWorld::create(plan);
    REQUIRE(world);
    return std::move(*world);
}

TEST_CASE(
    "rigid world: what falls freely falls as the steps add up, and spins on with its momentum") {
    RigidWorldPlan plan;
    plan.bodies.push_back({.shape = BoxShape{{0.1, 0.05, 0.02}},
                           .pose_W = Pose::at({0.0, 10.0, 0.0}),
                           .velocity_W = {{1.0, 0.0, 0.0}, {0.1, 9.0, 0.2}}});
    auto world = make_world(plan);
    const Vector3 before = compute_angular_momentum_W(world->inertia(0), world->state(0));
    const double energy_J = world->compute_energy_J();
    run(*world, 1.0);
    // Semi-implicit: v_n = n h g, x_n = h^2 g n (n + 1) / 2.
    CHECK(world->state(0).pose_W.position.y() ==
          Approx(10.0 - kGravity * 0.5 * 1.001).epsilon(1e-12));
    CHECK(world->state(0).pose_W.position.x() == Approx(1.0));
    const Vector3 after = compute_angular_momentum_W(world->inertia(0), world->state(0));
    CHECK((after - before).norm() <= 1.0e-12 * before.norm());
    CHECK(world->compute_energy_J() == Approx(energy_J).epsilon(1.0e-3));
}

TEST_CASE("rigid world: every shape comes to rest on the ground and stays there") {
    const std::vector<Vector3> tetrahedron{
        {0.05, 0.0, 0.0}, {-0.05, 0.0, 0.05}, {-0.05, 0.0, -0.05}, {0.0, 0.08, 0.0}};
    for (const SolidShape& shape :
         {SolidShape(SphereShape{0.05}), SolidShape(CapsuleShape{0.03, 0.05}),
          SolidShape(CylinderShape{0.05, 0.03}), SolidShape(BoxShape{{0.05, 0.03, 0.04}}),
          SolidShape(make_hull_shape(tetrahedron).value())}) {
        RigidWorldPlan plan;
        plan.settings.sleep_after_s = 0.0;
        plan.bodies = {make_ground(), {.shape = shape, .pose_W = Pose::at({0.0, 0.2, 0.0})}};
        auto world = make_world(plan);
        run(*world, 3.0);
        const Vector3 rested = world->shape_pose_W(1).position;
        run(*world, 0.5);
        CHECK((world->shape_pose_W(1).position - rested).norm() < 1.0e-6);
        CHECK(world->report().n_contacts >= 1);
        CHECK(world->report().deepest_m < 1.0e-5);
    }
}

TEST_CASE(
    "rigid world: on a slope a block sticks within the cone, and slides with g (sin a - mu cos a) "
    "beyond") {
    constexpr double kSlope_rad = 0.4;
    const Quaternion turn(AngleAxis(kSlope_rad, Vector3::UnitZ()));
    for (const double friction : {0.5, 0.2}) {
        RigidWorldPlan plan;
        RigidBodyPlan ground = make_ground(friction);
        ground.pose_W.orientation = turn;
        RigidBodyPlan block = make_cube(turn * Vector3(0.0, 0.05, 0.0));
        block.pose_W.orientation = turn;
        block.static_friction = block.dynamic_friction = friction;
        plan.settings.sleep_after_s = 0.0;
        plan.bodies = {ground, block};
        auto world = make_world(plan);
        run(*world, 0.5);
        const double slides =
            kGravity * (std::sin(kSlope_rad) - friction * std::cos(kSlope_rad)) * 0.5;
        const Vector3 velocity = turn.conjugate() * world->state(1).velocity_W.linear;
        CHECK(-velocity.x() == Approx(std::max(slides, 0.0)).margin(1.0e-6));
        CHECK(std::abs(velocity.y()) < 1.0e-8);
    }
}

TEST_CASE("rigid world: a ball bounces to e squared of its height, never higher") {
    for (const double restitution : {0.0, 0.5, 0.9}) {
        RigidWorldPlan plan;
        plan.settings.sleep_after_s = 0.0;
        plan.bodies = {make_ground(),
                       {.shape = SphereShape{0.05},
                        .pose_W = Pose::at({0.0, 1.05, 0.0}),
                        .restitution = restitution}};
        auto world = make_world(plan);
        double highest_m = 0.0;
        bool is_up = false;
        for (int i = 0; i < 1500; ++i) {
            world->step(kStep_s);
            is_up = is_up || world->report().n_contacts > 0;
            if (is_up && world->state(1).velocity_W.linear.y() > 0.0) {
                highest_m = std::max(highest_m, world->state(1).pose_W.position.y() - 0.05);
            }
        }
        CHECK(highest_m <= restitution * restitution + 0.01);
        CHECK(highest_m >= restitution * restitution - 0.03);
    }
}

TEST_CASE("rigid world: a body at 100 m/s is caught by a wall of a millimetre") {
    RigidWorldPlan plan;
    plan.bodies = {{.shape = BoxShape{{0.0005, 1.0, 1.0}}, .role = BodyRole::stays},
                   {.shape = SphereShape{0.01},
                    .pose_W = Pose::at({-1.0372, 0.1, 0.0}),
                    .velocity_W = {{100.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}}};
    plan.settings.gravity_W.setZero();
    auto world = make_world(plan);
    run(*world, 0.1);
    CHECK(world->state(1).pose_W.position.x() == Approx(-0.0105).margin(1.0e-6));
    CHECK(world->state(1).velocity_W.linear.norm() < 1.0e-6);
}

TEST_CASE(
    "rigid world: bodies that begin in each other part no faster than stated, and get no energy of "
    "it") {
    RigidWorldPlan plan;
    plan.settings.gravity_W.setZero();
    plan.settings.most_push_m_per_s = 0.2;
    plan.settings.sleep_after_s = 0.0;
    plan.bodies = {make_cube({0.0, 0.0, 0.0}), make_cube({0.02, 0.01, 0.0})};
    auto world = make_world(plan);
    Vector3 last = world->state(1).pose_W.position - world->state(0).pose_W.position;
    for (int i = 0; i < 2000; ++i) {
        world->step(kStep_s);
        const Vector3 now = world->state(1).pose_W.position - world->state(0).pose_W.position;
        REQUIRE((now - last).norm() <= 0.2 * kStep_s * 1.0001);
        REQUIRE(world->compute_energy_J() < 1.0e-12);
        last = now;
    }
    CHECK(world->report().deepest_m < 1.0e-5);
}

TEST_CASE("rigid world: what lies deep is lifted to the ground and no higher, in long steps too") {
    RigidWorldPlan plan;
    plan.bodies = {make_ground(), make_cube({0.0, 0.045, 0.0})};
    auto world = make_world(plan);
    for (int i = 0; i < 40; ++i) {
        world->step(0.05);
        REQUIRE(world->state(1).pose_W.position.y() <= 0.05 + 1.0e-9);
    }
    CHECK(world->state(1).pose_W.position.y() >= 0.05 - 1.0e-5);
}

TEST_CASE("rigid world: a stack of ten stands, sleeps, and wakes when it is pushed") {
    RigidWorldPlan plan;
    plan.bodies = {make_ground()};
    for (int i = 0; i < 10; ++i) {
        plan.bodies.push_back(make_cube({0.0, 0.05 + 0.1 * i, 0.0}));
    }
    auto world = make_world(plan);
    run(*world, 0.4);
    CHECK(world->report().n_contacts == 40);
    CHECK(world->report().n_unconverged == 0);
    run(*world, 0.6);
    CHECK(world->report().n_asleep == 10);
    CHECK(world->report().n_solved == 0);
    for (int i = 0; i < 10; ++i) {
        CHECK((world->shape_pose_W(i + 1).position - Vector3(0.0, 0.05 + 0.1 * i, 0.0)).norm() <
              1e-7);
    }
    world->push(10, {{30.0, 0.0, 0.0}, {0.0, 0.0, 0.0}});
    world->step(kStep_s);
    CHECK(world->report().n_asleep == 0);
    CHECK(world->state(10).velocity_W.linear.x() > 0.0);
}

TEST_CASE("rigid world: what falls on a sleeper wakes it, and a wall that is moved does") {
    RigidWorldPlan plan;
    plan.settings.sleep_after_s = 0.1;
    plan.bodies = {make_ground(),
                   make_cube({0.0, 0.05, 0.0}),
                   make_cube({0.0, 2.0, 0.0}),
                   {.shape = BoxShape{Vector3::Constant(0.05)},
                    .role = BodyRole::stays,
                    .pose_W = Pose::at({1.0, 0.05, 0.0})}};
    auto world = make_world(plan);
    run(*world, 0.3);
    CHECK(world->is_asleep(1));
    CHECK_FALSE(world->is_asleep(2));
    run(*world, 0.35);
    CHECK_FALSE(world->is_asleep(1));
    run(*world, 1.0);
    REQUIRE(world->is_asleep(1));
    world->place(3, Pose::at({0.099, 0.05, 0.0}), {});
    world->step(kStep_s);
    CHECK_FALSE(world->is_asleep(1));
}

TEST_CASE("rigid world: an island that no hand touches is stepped seldom, and as far") {
    RigidWorldPlan plan;
    plan.settings.slow_period_s = 0.01;
    plan.settings.gravity_W.setZero();
    RigidBodyPlan cube = make_cube({0.0, 0.0, 0.0});
    cube.velocity_W.linear = {0.3, 0.0, 0.0};
    plan.bodies = {cube, make_cube({0.0, 5.0, 0.0})};
    auto world = make_world(plan);
    int n_solved = 0;
    for (int i = 0; i < 100; ++i) {
        world->push(1, {{0.0, 0.1, 0.0}, {0.0, 0.0, 0.0}});
        world->step(kStep_s);
        n_solved += world->report().n_solved;
    }
    CHECK(n_solved == 110);
    CHECK(world->state(0).pose_W.position.x() == Approx(0.03));
    CHECK(world->state(1).velocity_W.linear.y() == Approx(0.01));
}

// What hangs from the world by each joint, for a while.
TEST_CASE(
    "rigid world: joints hold what they join within a tenth of a millimetre, and a pendulum keeps "
    "its energy") {
    for (const JointKind kind : {JointKind::ball, JointKind::hinge, JointKind::slider,
                                 JointKind::fixed, JointKind::distance}) {
        RigidWorldPlan plan;
        plan.settings.sleep_after_s = 0.0;
        plan.bodies = {make_cube({0.5, 0.0, 0.0})};
        plan.joints = {{.kind = kind,
                        .body_b = 0,
                        .anchor_W = Vector3::Zero(),
                        .other_anchor_W = {0.5, 0.0, 0.0},
                        .axis_W = kind == JointKind::slider ? Vector3(0.6, 0.8, 0.0)
                                                            : Vector3(0.0, 0.0, 1.0)}};
        auto world = make_world(plan);
        const double energy_J = world->compute_energy_J();
        run(*world, 2.0);
        const Vector3 at = world->state(0).pose_W.position;
        INFO("joint " << static_cast<int>(kind));
        if (kind == JointKind::slider) {
            const Vector3 away = at - Vector3(0.5, 0.0, 0.0);
            CHECK(away.cross(Vector3(0.6, 0.8, 0.0)).norm() < 1.0e-4);
            // Down along the axis with g 0.8.
            CHECK(away.norm() == Approx(0.5 * kGravity * 0.8 * 4.0).epsilon(1.0e-3));
        } else if (kind == JointKind::fixed) {
            CHECK((at - Vector3(0.5, 0.0, 0.0)).norm() < 1.0e-4);
        } else {
            CHECK(at.norm() == Approx(0.5).margin(1.0e-4));
            CHECK(world->compute_energy_J() == Approx(energy_J).margin(0.02 * kGravity * 0.5));
        }
    }
}

TEST_CASE("rigid world: a motor brings a hinge to its speed, a limit stops it, friction holds it") {
    RigidWorldPlan plan;
    plan.settings.gravity_W.setZero();
    plan.settings.sleep_after_s = 0.0;
    plan.bodies = {make_cube({0.0, 0.0, 0.0})};
    JointPlan hinge{.kind = JointKind::hinge, .body_b = 0, .axis_W = {0.0, 0.0, 1.0}};
    hinge.drive = {.upper = 1.0, .motor_speed = 2.0, .motor_force = 0.01};
    plan.joints = {hinge};
    auto world = make_world(plan);
    run(*world, 0.2);
    // Torque over inertia: 0.01 / (1/600) = 6 rad/s^2.
    CHECK(world->state(0).velocity_W.angular.z() == Approx(1.2));
    run(*world, 0.3);
    CHECK(world->state(0).velocity_W.angular.z() == Approx(2.0));
    run(*world, 1.0);
    CHECK(world->joint_travel(0) == Approx(1.0).margin(1.0e-4));
    CHECK(world->state(0).velocity_W.angular.norm() < 1.0e-6);
    plan.joints[0].drive = {.friction = 0.02};
    world = make_world(plan);
    for (int i = 0; i < 100; ++i) {
        world->push(0, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.019}});
        world->step(kStep_s);
    }
    CHECK(std::abs(world->joint_travel(0)) < 1.0e-9);
}

TEST_CASE(
    "rigid world: joined bodies do not push each other unless asked, and the same run is the same "
    "to the bit") {
    RigidWorldPlan plan;
    plan.bodies = {make_ground()};
    Random random(4);
    for (int i = 0; i < 8; ++i) {
        RigidBodyPlan cube = make_cube({0.09 * i, 0.5, 0.0});
        plan.bodies.push_back(cube);
        if (i > 0) {
            plan.joints.push_back(
                {.body_a = i, .body_b = i + 1, .anchor_W = {0.09 * i - 0.045, 0.5, 0.0}});
        }
    }
    auto one = make_world(plan);
    auto other = make_world(plan);
    one->step(kStep_s);
    other->step(kStep_s);
    CHECK(one->report().n_contacts == 0);
    run(*one, 1.0);
    run(*other, 1.0);
    for (int i = 1; i < 9; ++i) {
        CHECK(one->state(i).pose_W.position == other->state(i).pose_W.position);
        CHECK(one->state(i).pose_W.orientation.coeffs() ==
              other->state(i).pose_W.orientation.coeffs());
    }
}

TEST_CASE("rigid world: what is no number or not there is passed over or refused") {
    RigidWorldPlan plan;
    plan.bodies = {make_ground(), make_cube({0.0, 0.05, 0.0})};
    auto world = make_world(plan);
    const Vector3 before = world->state(1).pose_W.position;
    world->step(0.0);
    world->step(std::nan(""));
    world->push(1, {Vector3::Constant(std::nan("")), Vector3::Zero()});
    world->push(7, {});
    world->push(0, {Vector3::Ones(), Vector3::Zero()});
    world->place(1, Pose::at(Vector3::Constant(std::nan(""))), {});
    world->place(-1, Pose{}, {});
    CHECK(world->state(1).pose_W.position == before);
    const auto is_refused = [&](auto spoil) {
        RigidWorldPlan spoilt = plan;
        spoil(spoilt);
        const auto result = RigidWorld::create(spoilt);
        return !result;
    };
    CHECK_FALSE(is_refused([](RigidWorldPlan&) {}));
    CHECK(is_refused([](RigidWorldPlan& p) { p.bodies[1].mass_kg = -1.0; }));
    CHECK(is_refused([](RigidWorldPlan& p) { p.bodies[1].restitution = 1.5; }));
    CHECK(is_refused([](RigidWorldPlan& p) { p.bodies[1].dynamic_friction = 0.9; }));
    CHECK(is_refused([](RigidWorldPlan& p) { p.bodies[1].pose_W.position.x() = std::nan(""); }));
    CHECK(is_refused([](RigidWorldPlan& p) { p.bodies[1].shape = SphereShape{-1.0}; }));
    CHECK(is_refused(
        [](RigidWorldPlan& p) { p.bodies[1].shape = touchable(make_plate(1.0, 1.0, 2)); }));
    CHECK(is_refused([](RigidWorldPlan& p) { p.settings.push_rate_per_s = -1.0; }));
    CHECK(is_refused([](RigidWorldPlan& p) { p.settings.solver.max_iterations = 0; }));
    CHECK(is_refused([](RigidWorldPlan& p) { p.settings.gravity_W.x() = 1.0e9; }));
    CHECK(is_refused([](RigidWorldPlan& p) { p.joints = {{.body_a = -1, .body_b = 0}}; }));
    CHECK(is_refused([](RigidWorldPlan& p) { p.joints = {{.body_a = 5, .body_b = 1}}; }));
    plan.bodies[1].mass_kg = -1.0;
    plan.bodies[1].density_kg_per_m3 = 0.0;
    const auto refused = RigidWorld::create(plan);
    REQUIRE_FALSE(refused);
    CHECK(to_sentence(refused.error()).find("body 1") != std::string::npos);
}

TEST_CASE(
    "rigid world: of balls that hang in a row the last one leaves, and energy is never gained") {
    for (const double restitution : {1.0, 0.8}) {
        RigidWorldPlan plan;
        plan.settings.gravity_W.setZero();
        plan.settings.sleep_after_s = 0.0;
        for (int i = 0; i < 5; ++i) {
            plan.bodies.push_back({.shape = SphereShape{0.05},
                                   .mass_kg = 1.0,
                                   .pose_W = Pose::at({0.1 * i - (i == 0 ? 0.05 : 0.0), 0.0, 0.0}),
                                   .restitution = restitution});
        }
        plan.bodies[0].velocity_W.linear.x() = 1.0;
        auto world = make_world(plan);
        double energy_J = world->compute_energy_J();
        for (int i = 0; i < 200; ++i) {
            world->step(kStep_s);
            REQUIRE(world->compute_energy_J() <= energy_J * (1.0 + 1.0e-9));
            energy_J = world->compute_energy_J();
        }
        const auto speed = [&](int i) { return world->state(i).velocity_W.linear.x(); };
        double momentum_Ns = 0.0;
        for (int i = 0; i < 5; ++i) {
            momentum_Ns += speed(i);
        }
        CHECK(momentum_Ns == Approx(1.0));
        if (restitution == 1.0) {
            CHECK(speed(4) == Approx(1.0));
            CHECK(std::abs(speed(0)) < 1.0e-6);
        } else {
            // Passed on from ball to ball: ((1 + e) / 2)^4.
            CHECK(speed(4) == Approx(std::pow(0.9, 4)).epsilon(0.02));
        }
    }
}

}  // namespace
}  // namespace fulcrum
