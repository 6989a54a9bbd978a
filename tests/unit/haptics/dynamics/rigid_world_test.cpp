#include "haptics/dynamics/rigid_world.h"

#include "haptics/geometry/shape.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"
#include "tests/support/rigid_worlds.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kStep_s = 1.0e-3;
constexpr double kGravity = 9.81;

RigidBodyPlan make_cube(const Vector3& at) {
    return plan_cube(0.05, at, 1.0);
}

TEST_CASE("rigid world: what falls freely falls as steps add up, and spins on with its momentum") {
    RigidWorldPlan plan;
    plan.bodies = {plan_body(BoxShape{{0.1, 0.05, 0.02}}, Pose::at({0.0, 10.0, 0.0}), 0.0,
                             {{1.0, 0.0, 0.0}, {0.1, 9.0, 0.2}})};
    auto world = make_rigid_world(plan);
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
        CAPTURE(shape.index());
        auto world = make_rigid_world(
            plan_awake({plan_ground(), plan_body(shape, Pose::at({0.0, 0.2, 0.0}))}));
        run(*world, 3.0);
        const Vector3 rested = world->shape_pose_W(1).position;
        run(*world, 0.5);
        CHECK((world->shape_pose_W(1).position - rested).norm() < 1.0e-6);
        CHECK(world->report().n_contacts >= 1);
        CHECK(world->report().deepest_m < 1.0e-5);
    }
}

struct Friction {
    double at_rest, in_motion;
};

// Two frictions count as their geometric mean, at rest and in motion.
TEST_CASE("rigid world: a block on a slope sticks within the cone, beyond it slides by Coulomb") {
    struct Slope {
        double rad;
        Friction plane, block;
        double within;  // of the speed after half a second
    };
    constexpr Friction kRough{0.9, 0.4};
    constexpr Friction kSmooth{0.4, 0.1};  // with the rough one: 0.6 at rest, 0.2 in motion
    for (const Slope& slope :
         {Slope{0.4, {0.5, 0.5}, {0.5, 0.5}, 1.0e-6}, Slope{0.4, {0.2, 0.2}, {0.2, 0.2}, 1.0e-6},
          Slope{std::atan(0.59), kRough, kSmooth, 1.0e-6},
          Slope{std::atan(0.59), kSmooth, kRough, 1.0e-6},
          Slope{std::atan(0.65), kRough, kSmooth, 0.01},
          Slope{std::atan(0.65), kSmooth, kRough, 0.01}}) {
        CAPTURE(slope.rad, slope.plane.at_rest, slope.block.at_rest);
        const Quaternion turn(AngleAxis(slope.rad, Vector3::UnitZ()));
        RigidWorldPlan plan =
            plan_awake({plan_ground(), make_cube(turn * Vector3(0.0, 0.05, 0.0))});
        for (const std::size_t i : {0U, 1U}) {
            const Friction& friction = i == 0 ? slope.plane : slope.block;
            plan.bodies[i].pose_W.orientation = turn;
            plan.bodies[i].static_friction = friction.at_rest;
            plan.bodies[i].dynamic_friction = friction.in_motion;
        }
        auto world = make_rigid_world(plan);
        run(*world, 0.5);
        const double at_rest = std::sqrt(slope.plane.at_rest * slope.block.at_rest);
        const double in_motion = std::sqrt(slope.plane.in_motion * slope.block.in_motion);
        const double slides =
            std::tan(slope.rad) < at_rest
                ? 0.0
                : 0.5 * kGravity * (std::sin(slope.rad) - in_motion * std::cos(slope.rad));
        const Vector3 velocity = turn.conjugate() * world->state(1).velocity_W.linear;
        CHECK(-velocity.x() ==
              Approx(slides).epsilon(slope.within).margin(std::min(slope.within, 1.0e-6)));
        CHECK(std::abs(velocity.y()) < 1.0e-8);
    }
}

TEST_CASE("rigid world: a ball bounces to e squared of its height; at 100 m/s a wall holds it") {
    struct Bounce {
        double ground, ball, least_m;
    };
    for (const Bounce& bounce :
         {Bounce{0.0, 0.0, 0.0}, Bounce{0.0, 0.5, 0.22}, Bounce{0.0, 0.9, 0.78},
          Bounce{0.8, 0.0, 0.62}, Bounce{0.0, 0.8, 0.62}, Bounce{0.3, 0.8, 0.62}}) {
        CAPTURE(bounce.ground, bounce.ball);
        auto world = make_rigid_world(
            plan_awake({with_restitution(plan_ground(), bounce.ground),
                        with_restitution(plan_ball(0.05, {0.0, 1.05, 0.0}), bounce.ball)}));
        run(*world, 0.46);  // it arrives after sqrt(2 / g)
        double highest_m = 0.0;
        for (int i = 0; i < 1040; ++i) {
            world->step(kStep_s);
            highest_m = std::max(highest_m, world->state(1).pose_W.position.y() - 0.05);
        }
        const double e = std::max(bounce.ground, bounce.ball);
        CHECK(highest_m <= e * e + (e > 0.0 ? 0.01 : 1.0e-3));
        CHECK(highest_m >= bounce.least_m);
    }
    RigidWorldPlan plan;
    plan.bodies = {plan_wall(BoxShape{{0.0005, 1.0, 1.0}}, Vector3::Zero()),
                   plan_ball(0.01, {-1.0372, 0.1, 0.0}, 0.0, {100.0, 0.0, 0.0})};
    plan.settings.gravity_W.setZero();
    auto world = make_rigid_world(plan);
    run(*world, 0.1);
    CHECK(world->state(1).pose_W.position.x() == Approx(-0.0105).margin(1.0e-6));
    CHECK(world->state(1).velocity_W.linear.norm() < 1.0e-6);
}

TEST_CASE("rigid world: bodies that begin in each other part as slowly as stated, without energy") {
    RigidWorldPlan plan =
        plan_weightless({make_cube({0.0, 0.0, 0.0}), make_cube({0.02, 0.01, 0.0})});
    plan.settings.most_push_m_per_s = 0.2;
    auto world = make_rigid_world(plan);
    const auto find_apart = [&] {
        return Vector3(world->state(1).pose_W.position - world->state(0).pose_W.position);
    };
    for (int i = 0; i < 2000; ++i) {
        const Vector3 last = find_apart();
        world->step(kStep_s);
        REQUIRE((find_apart() - last).norm() <= 0.2 * kStep_s * 1.0001);
        REQUIRE(world->compute_energy_J() < 1.0e-12);
    }
    CHECK(world->report().deepest_m < 1.0e-5);
}

TEST_CASE("rigid world: what lies deep is lifted to the ground and no higher, in long steps too") {
    RigidWorldPlan plan;
    plan.bodies = {plan_ground(), make_cube({0.0, 0.045, 0.0})};
    auto world = make_rigid_world(plan);
    for (int i = 0; i < 40; ++i) {
        world->step(0.05);
        REQUIRE(world->state(1).pose_W.position.y() <= 0.05 + 1.0e-9);
    }
    CHECK(world->state(1).pose_W.position.y() >= 0.05 - 1.0e-5);
}

TEST_CASE("rigid world: while one end of a plank is pushed out the other falls freely") {
    constexpr double kHalf_m = 0.1;
    constexpr double kThick_m = 0.01;
    RigidWorldPlan plan;
    // One end 0.1 mm deep, the other 0.15 mm high.
    const Quaternion tilt(AngleAxis(1.25e-3, Vector3::UnitZ()));
    plan.bodies = {plan_ground(), plan_body(BoxShape{{kHalf_m, kThick_m, 0.02}},
                                            {{0.0, kThick_m + 2.5e-5, 0.0}, tilt})};
    auto world = make_rigid_world(plan);
    const auto height_m = [&](double x) {
        return (world->shape_pose_W(1) * Vector3(x, -kThick_m, 0.0)).y();
    };
    const double deep_m = height_m(-kHalf_m);
    const double high_m = height_m(kHalf_m);
    REQUIRE(deep_m < -9.0e-5);
    REQUIRE(high_m > 1.4e-4);
    run(*world, 0.004);
    // A rod about its end: the far one falls by 3/2 g t^2 / 2; the push, which turns the plank too, only adds to it.
    const double fall_m = 0.5 * 1.5 * kGravity * 16.0e-6;
    CHECK(height_m(-kHalf_m) > deep_m);
    CHECK(height_m(kHalf_m) < high_m - 0.9 * fall_m);
    run(*world, 0.4);
    CHECK(height_m(-kHalf_m) == Approx(0.0).margin(5.0e-6));
    CHECK(height_m(kHalf_m) == Approx(0.0).margin(5.0e-6));
}

TEST_CASE("rigid world: a stack of ten stands, sleeps, and wakes when it is pushed") {
    RigidWorldPlan plan;
    plan.bodies = {plan_ground()};
    for (int i = 0; i < 10; ++i) {
        plan.bodies.push_back(make_cube({0.0, 0.05 + 0.1 * i, 0.0}));
    }
    auto world = make_rigid_world(plan);
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
    plan.bodies = {plan_ground(), make_cube({0.0, 0.05, 0.0}), make_cube({0.0, 2.0, 0.0}),
                   plan_wall(BoxShape{Vector3::Constant(0.05)}, {1.0, 0.05, 0.0})};
    auto world = make_rigid_world(plan);
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
    plan.bodies = {make_cube({0.0, 0.0, 0.0}), make_cube({0.0, 5.0, 0.0})};
    plan.bodies[0].velocity_W.linear = {0.3, 0.0, 0.0};
    auto world = make_rigid_world(plan);
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

TEST_CASE("rigid world: joined bodies do not push each other, and a run is the same to the bit") {
    RigidWorldPlan plan;
    plan.bodies = {plan_ground()};
    for (int i = 0; i < 8; ++i) {
        plan.bodies.push_back(make_cube({0.09 * i, 0.5, 0.0}));
        if (i > 0) {
            plan.joints.push_back(
                {.body_a = i, .body_b = i + 1, .anchor_W = {0.09 * i - 0.045, 0.5, 0.0}});
        }
    }
    auto one = make_rigid_world(plan);
    auto other = make_rigid_world(plan);
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
    plan.bodies = {plan_ground(), make_cube({0.0, 0.05, 0.0})};
    auto world = make_rigid_world(plan);
    const Vector3 before = world->state(1).pose_W.position;
    world->step(0.0);
    world->step(kNan);
    world->push(1, {Vector3::Constant(kNan), Vector3::Zero()});
    world->push(7, {});
    world->push(0, {Vector3::Ones(), Vector3::Zero()});
    world->place(1, Pose::at(Vector3::Constant(kNan)), {});
    world->place(-1, Pose{}, {});
    CHECK(world->state(1).pose_W.position == before);
    using P = RigidWorldPlan;
    check_refused(
        plan, [](const P& spoilt) { return RigidWorld::create(spoilt).has_value(); },
        {[](P& p) { p.bodies[1].mass_kg = -1.0; }, [](P& p) { p.bodies[1].restitution = 1.5; },
         [](P& p) { p.bodies[1].dynamic_friction = 0.9; },
         [](P& p) { p.bodies[1].pose_W.position.x() = kNan; },
         [](P& p) { p.bodies[1].shape = SphereShape{-1.0}; },
         [](P& p) { p.bodies[1].shape = touchable(make_plate(1.0, 1.0, 2)); },
         [](P& p) { p.settings.push_rate_per_s = -1.0; },
         [](P& p) { p.settings.solver.max_iterations = 0; },
         [](P& p) { p.settings.gravity_W.x() = 1.0e9; },
         [](P& p) { p.joints = {{.body_a = -1, .body_b = 0}}; },
         [](P& p) { p.joints = {{.body_a = 5, .body_b = 1}}; }});
    plan.bodies[1].mass_kg = -1.0;
    plan.bodies[1].density_kg_per_m3 = 0.0;
    CHECK(is_refused(RigidWorld::create(plan), "body 1"));
}

TEST_CASE("rigid world: of balls in a row the last one leaves, and energy is never gained") {
    for (const double restitution : {1.0, 0.8}) {
        CAPTURE(restitution);
        RigidWorldPlan plan = plan_weightless({});
        for (int i = 0; i < 5; ++i) {
            const Vector3 at(0.1 * i - (i == 0 ? 0.05 : 0.0), 0.0, 0.0);
            plan.bodies.push_back(with_restitution(plan_ball(0.05, at, 1.0), restitution));
        }
        plan.bodies[0].velocity_W.linear.x() = 1.0;
        auto world = make_rigid_world(plan);
        double energy_J = world->compute_energy_J();
        for (int i = 0; i < 200; ++i) {
            world->step(kStep_s);
            REQUIRE(world->compute_energy_J() <= energy_J * (1.0 + 1.0e-9));
            energy_J = world->compute_energy_J();
        }
        const auto speed = [&](int i) { return world->state(i).velocity_W.linear.x(); };
        CHECK(speed(0) + speed(1) + speed(2) + speed(3) + speed(4) == Approx(1.0));
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
