// What two bodies make of each other's materials, and what a joint between two that are free leaves as it was.
#include "tests/support/rigid_worlds.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kFall_m_per_s2 = 9.81;

// A block on a plane that leans by so much, half a second after it was laid there: how fast it goes down.
double slide_m_per_s(double slope_rad, const RigidBodyPlan& plane, const RigidBodyPlan& block) {
    const Quaternion turn(AngleAxis(slope_rad, Vector3::UnitZ()));
    RigidWorldPlan plan;
    plan.settings.sleep_after_s = 0.0;
    plan.bodies = {plane, block};
    plan.bodies[0].role = BodyRole::ground;
    plan.bodies[0].pose_W.orientation = turn;
    plan.bodies[1].shape = BoxShape{Vector3::Constant(0.05)};
    plan.bodies[1].mass_kg = 1.0;
    plan.bodies[1].pose_W = {turn * Vector3(0.0, 0.05, 0.0), turn};
    const auto world = make_rigid_world(plan);
    run(*world, 0.5);
    return -(turn.conjugate() * world->state(1).velocity_W.linear).x();
}

// How high a ball bounces that falls by a metre.
double bounce_m(double ground, double ball) {
    RigidWorldPlan plan;
    plan.settings.sleep_after_s = 0.0;
    plan.bodies = {
        {.role = BodyRole::ground, .restitution = ground},
        {.shape = SphereShape{0.05}, .pose_W = Pose::at({0.0, 1.05, 0.0}), .restitution = ball}};
    const auto world = make_rigid_world(plan);
    run(*world, 0.46);  // it arrives after sqrt(2 / g)
    double highest_m = 0.0;
    for (int i = 0; i < 900; ++i) {
        run(*world, 1.0e-3);
        highest_m = std::max(highest_m, world->state(1).pose_W.position.y() - 0.05);
    }
    return highest_m;
}

struct Momentum {
    Vector3 linear{Vector3::Zero()};
    Vector3 angular{Vector3::Zero()};  // about the world's origin
};

Momentum compute_momentum(const RigidWorld& world) {
    Momentum sum;
    for (int i = 0; i < 2; ++i) {
        const RigidState& state = world.state(i);
        const Vector3 p = world.inertia(i).mass_kg * state.velocity_W.linear;
        sum.linear += p;
        sum.angular +=
            state.pose_W.position.cross(p) + compute_angular_momentum_W(world.inertia(i), state);
    }
    return sum;
}

RigidBodyPlan make_flying(double mass_kg, const Vector3& half_m, Random& random) {
    RigidBodyPlan body{.shape = BoxShape{half_m}, .mass_kg = mass_kg};
    body.pose_W = {0.3 * random.in_cube(), random.turn(3.0)};
    body.velocity_W = {random.in_cube(), 4.0 * random.in_cube()};
    return body;
}

TEST_CASE("rigid world pairs: what hangs still is remembered from step to step") {
    RigidWorldPlan plan;
    plan.settings.sleep_after_s = 0.0;
    for (int i = 0; i < 5; ++i) {
        plan.bodies.push_back({.shape = BoxShape{{0.02, 0.05, 0.02}},
                               .mass_kg = 0.2,
                               .pose_W = Pose::at({0.0, -0.05 - 0.1 * i, 0.0})});
        plan.joints.push_back({.body_a = i - 1, .body_b = i, .anchor_W = {0.0, -0.1 * i, 0.0}});
    }
    const auto world = make_rigid_world(plan);
    int n_iterations = 0;
    for (int i = 0; i < 500; ++i) {
        run(*world, 1.0e-3);
        n_iterations += world->report().n_iterations;
    }
    // From nothing each step would take two.
    CHECK(n_iterations < 100);
}

TEST_CASE(
    "rigid world pairs: a joint of a pendulum is never off by more than what is left as it is") {
    RigidWorldPlan plan;
    plan.settings.sleep_after_s = 0.0;
    plan.bodies = {{.shape = BoxShape{Vector3::Constant(0.05)},
                    .mass_kg = 1.0,
                    .pose_W = Pose::at({0.5, 0.0, 0.0})}};
    plan.joints = {{.body_b = 0}};
    const auto world = make_rigid_world(plan);
    double worst_m = 0.0;
    for (int i = 0; i < 3000; ++i) {
        run(*world, 1.0e-3);
        worst_m = std::max(worst_m, (world->state(0).pose_W * Vector3(-0.5, 0.0, 0.0)).norm());
    }
    constexpr double kLeft_m = 1.0e-7;
    CHECK(worst_m < kLeft_m);
}

TEST_CASE("rigid world pairs: two frictions count as their geometric mean, at rest and in motion") {
    RigidBodyPlan plane;
    plane.static_friction = 0.9;
    plane.dynamic_friction = 0.4;
    RigidBodyPlan block;
    block.static_friction = 0.4;
    block.dynamic_friction = 0.1;
    // 0.6 at rest and 0.2 in motion.
    const double sticks_rad = std::atan(0.59);
    const double slides_rad = std::atan(0.65);
    const double expected_m_per_s =
        0.5 * kFall_m_per_s2 * (std::sin(slides_rad) - 0.2 * std::cos(slides_rad));
    CHECK(slide_m_per_s(sticks_rad, plane, block) == Approx(0.0).margin(1.0e-6));
    CHECK(slide_m_per_s(slides_rad, plane, block) == Approx(expected_m_per_s).epsilon(0.01));
    CHECK(slide_m_per_s(sticks_rad, block, plane) == Approx(0.0).margin(1.0e-6));
    CHECK(slide_m_per_s(slides_rad, block, plane) == Approx(expected_m_per_s).epsilon(0.01));
}

TEST_CASE("rigid world pairs: of two restitutions the greater counts") {
    CHECK(bounce_m(0.8, 0.0) == Approx(0.64).margin(0.02));
    CHECK(bounce_m(0.0, 0.8) == Approx(0.64).margin(0.02));
    CHECK(bounce_m(0.3, 0.8) == Approx(0.64).margin(0.02));
    CHECK(bounce_m(0.0, 0.0) < 1.0e-3);
}

TEST_CASE(
    "rigid world pairs: joints, motors, friction and limits between two free bodies leave their "
    "momentum") {
    Random random(31);
    const JointDrive drives[] = {{},
                                 {.motor_speed = 3.0, .motor_force = 0.3},
                                 {.friction = 0.2},
                                 {.lower = -0.1, .upper = 0.1}};
    for (const JointKind kind : {JointKind::ball, JointKind::hinge, JointKind::slider,
                                 JointKind::fixed, JointKind::distance}) {
        const bool has_drives = kind == JointKind::hinge || kind == JointKind::slider;
        for (const JointDrive& drive : drives) {
            if (!has_drives && &drive != &drives[0]) {
                continue;
            }
            RigidWorldPlan plan;
            plan.settings.gravity_W.setZero();
            plan.settings.sleep_after_s = 0.0;
            plan.bodies = {make_flying(1.0, {0.05, 0.08, 0.03}, random),
                           make_flying(0.3, {0.02, 0.06, 0.04}, random)};
            plan.joints = {{.kind = kind,
                            .body_a = 0,
                            .body_b = 1,
                            .anchor_W = 0.2 * random.in_cube(),
                            .other_anchor_W = Vector3(0.5, 0.4, 0.3),
                            .axis_W = random.direction(),
                            .drive = drive}};
            const auto world = make_rigid_world(plan);
            const Momentum before = compute_momentum(*world);
            run(*world, 1.0);
            const Momentum after = compute_momentum(*world);
            CAPTURE(static_cast<int>(kind), &drive - &drives[0]);
            CHECK((after.linear - before.linear).norm() < 1.0e-9 * before.linear.norm());
            // A limit that was passed is moved back, and what is moved has another arm.
            const double moved = std::isfinite(drive.upper) ? 5.0e-3 : 1.0e-6;
            CHECK((after.angular - before.angular).norm() < moved * before.angular.norm());
        }
    }
}

}  // namespace
}  // namespace fulcrum
