// Joints in a world: what they hold, their motors and limits, what goes round in a step, and what hangs from what.
#include "haptics/dynamics/rigid_world.h"
#include "tests/support/rigid_worlds.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace fulcrum {
namespace {

constexpr double kStep_s = 1.0e-3;
constexpr double kGravity = 9.81;
constexpr JointKind kKinds[] = {JointKind::ball, JointKind::hinge, JointKind::slider,
                                JointKind::fixed, JointKind::distance};

// What hangs from the world by each joint, for a while.
TEST_CASE("rigid world: joints hold to a tenth of a millimetre, and a pendulum keeps its energy") {
    for (const JointKind kind : kKinds) {
        CAPTURE(static_cast<int>(kind));
        RigidWorldPlan plan = plan_awake({plan_cube(0.05, {0.5, 0.0, 0.0}, 1.0)});
        plan.joints = {{.kind = kind,
                        .body_b = 0,
                        .anchor_W = Vector3::Zero(),
                        .other_anchor_W = {0.5, 0.0, 0.0},
                        .axis_W = kind == JointKind::slider ? Vector3(0.6, 0.8, 0.0)
                                                            : Vector3(0.0, 0.0, 1.0)}};
        auto world = make_rigid_world(plan);
        const double energy_J = world->compute_energy_J();
        run(*world, 2.0);
        const Vector3 at = world->state(0).pose_W.position;
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

TEST_CASE("rigid world pairs: a pendulum's joint is never off by more than what is left alone") {
    RigidWorldPlan plan = plan_awake({plan_cube(0.05, {0.5, 0.0, 0.0}, 1.0)});
    plan.joints = {{.body_b = 0}};
    const auto world = make_rigid_world(plan);
    double worst_m = 0.0;
    for (int i = 0; i < 3000; ++i) {
        world->step(kStep_s);
        worst_m = std::max(worst_m, (world->state(0).pose_W * Vector3(-0.5, 0.0, 0.0)).norm());
    }
    constexpr double kLeft_m = 1.0e-7;
    CHECK(worst_m < kLeft_m);
}

TEST_CASE("rigid world pairs: what hangs still is remembered from step to step") {
    RigidWorldPlan plan = plan_awake({});
    for (int i = 0; i < 5; ++i) {
        plan.bodies.push_back(plan_box({0.02, 0.05, 0.02}, {0.0, -0.05 - 0.1 * i, 0.0}, 0.2));
        plan.joints.push_back({.body_a = i - 1, .body_b = i, .anchor_W = {0.0, -0.1 * i, 0.0}});
    }
    const auto world = make_rigid_world(plan);
    int n_iterations = 0;
    for (int i = 0; i < 500; ++i) {
        world->step(kStep_s);
        n_iterations += world->report().n_iterations;
    }
    // From nothing each step would take two.
    CHECK(n_iterations < 100);
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

TEST_CASE("rigid world pairs: joints, drives and limits between free bodies leave their momentum") {
    Random random(31);
    const JointDrive drives[] = {{},
                                 {.motor_speed = 3.0, .motor_force = 0.3},
                                 {.friction = 0.2},
                                 {.lower = -0.1, .upper = 0.1}};
    const auto make_flying = [&](double mass_kg, const Vector3& half_m) {
        const Pose pose_W{0.3 * random.in_cube(), random.turn(3.0)};
        const Vector3 linear = random.in_cube();
        return plan_body(BoxShape{half_m}, pose_W, mass_kg, {linear, 4.0 * random.in_cube()});
    };
    for (const JointKind kind : kKinds) {
        const bool has_drives = kind == JointKind::hinge || kind == JointKind::slider;
        for (const JointDrive& drive : drives) {
            if (!has_drives && &drive != &drives[0]) {
                continue;
            }
            const RigidBodyPlan heavy = make_flying(1.0, {0.05, 0.08, 0.03});
            RigidWorldPlan plan = plan_weightless({heavy, make_flying(0.3, {0.02, 0.06, 0.04})});
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

// A body joined to the world about or along z, without weight.
std::unique_ptr<RigidWorld> make_joined(JointKind kind, const JointDrive& drive,
                                        const Twist& velocity_W = {},
                                        const SolidShape& shape = SphereShape{0.05},
                                        double sleep_after_s = 0.5) {
    RigidWorldPlan plan = plan_weightless({plan_body(shape, Pose{}, 1.0, velocity_W)});
    plan.settings.sleep_after_s = sleep_after_s;
    plan.joints = {{.kind = kind, .body_b = 0, .axis_W = Vector3::UnitZ(), .drive = drive}};
    return make_rigid_world(plan);
}

TEST_CASE("rigid world: a motor brings a hinge to its speed, a limit stops it, friction holds it") {
    const SolidShape cube = BoxShape{Vector3::Constant(0.05)};
    const auto world = make_joined(
        JointKind::hinge, {.upper = 1.0, .motor_speed = 2.0, .motor_force = 0.01}, {}, cube, 0.0);
    const auto spin = [&] { return world->state(0).velocity_W.angular; };
    run(*world, 0.2);
    // Torque over inertia: 0.01 / (1/600) = 6 rad/s^2.
    CHECK(spin().z() == Approx(1.2));
    run(*world, 0.3);
    CHECK(spin().z() == Approx(2.0));
    run(*world, 1.0);
    CHECK(world->joint_travel(0) == Approx(1.0).margin(1.0e-4));
    CHECK(spin().norm() < 1.0e-6);
    const auto held = make_joined(JointKind::hinge, {.friction = 0.02}, {}, cube, 0.0);
    for (int i = 0; i < 100; ++i) {
        held->push(0, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.019}});
        held->step(kStep_s);
    }
    CHECK(std::abs(held->joint_travel(0)) < 1.0e-9);
}

TEST_CASE(
    "rigid world: a motor turns a hinge to its limit, beyond two turns; one side may be free") {
    for (const double limit_rad : {4.0, 15.0}) {
        CAPTURE(limit_rad);
        auto up = make_joined(JointKind::hinge,
                              {.upper = limit_rad, .motor_speed = 8.0, .motor_force = 1.0});
        auto down = make_joined(JointKind::hinge,
                                {.lower = -limit_rad, .motor_speed = -8.0, .motor_force = 1.0});
        run(*up, 3.0);
        run(*down, 3.0);
        CHECK(up->joint_travel(0) == Approx(limit_rad).epsilon(1.0e-6));
        CHECK(down->joint_travel(0) == Approx(-limit_rad).epsilon(1.0e-6));
        CHECK(up->state(0).velocity_W.angular.norm() <= 1.0e-6);
    }
    auto world = make_joined(JointKind::hinge, {.upper = 1.0}, {Vector3::Zero(), {0.0, 0.0, -4.0}});
    run(*world, 1.5);
    CHECK(world->joint_travel(0) == Approx(-6.0).epsilon(1.0e-3));
    CHECK(world->state(0).velocity_W.angular.z() == Approx(-4.0).epsilon(1.0e-6));
}

TEST_CASE("rigid world: a slider passes no limit, and a slow motor is not put to sleep") {
    for (const double speed_m_per_s : {10.0, -10.0}) {
        CAPTURE(speed_m_per_s);
        auto world = make_joined(JointKind::slider, {.lower = -1.0e-3, .upper = 2.0e-3},
                                 {{0.0, 0.0, speed_m_per_s}, Vector3::Zero()});
        for (int i = 0; i < 20; ++i) {
            world->step(kStep_s);
            CHECK(world->joint_travel(0) <= 2.0e-3 + 1.0e-7);
            CHECK(world->joint_travel(0) >= -1.0e-3 - 1.0e-7);
        }
    }
    auto turning = make_joined(JointKind::hinge, {.motor_speed = 0.02, .motor_force = 1.0});
    run(*turning, 2.0);
    CHECK(turning->joint_travel(0) == Approx(0.04).epsilon(1.0e-3));
    auto held = make_joined(JointKind::hinge, {.motor_speed = 0.0, .motor_force = 1.0});
    run(*held, 1.0);
    CHECK(held->is_asleep(0));
}

constexpr double kArm_m = 0.1;
// What a solver of 1e-9 m/s and rows that look for 1e-7 m leave.
constexpr double kPinned_m = 1.0e-6;

// Of speeds and energy: velocities are those of chords, which 0.2 rad a part has (w h)^2 / 6 of.
constexpr double kMostLate = 0.04 / 6.0;

// A ball on a weightless arm goes round the origin in the xy plane.
RigidWorldPlan make_round(JointKind kind, double spin_rad_per_s) {
    const double spin = kind == JointKind::distance ? 0.0 : spin_rad_per_s;
    RigidWorldPlan plan = plan_weightless(
        {plan_ball(0.02, {kArm_m, 0.0, 0.0}, 0.2, {0.0, spin_rad_per_s * kArm_m, 0.0})});
    plan.bodies[0].velocity_W.angular.z() = spin;
    plan.joints.push_back({.kind = kind,
                           .body_b = 0,
                           .anchor_W = Vector3::Zero(),
                           .other_anchor_W = {kArm_m, 0.0, 0.0},
                           .axis_W = Vector3::UnitZ()});
    return plan;
}

TEST_CASE("rigid world parts: what goes round stays on its circle, and is where it should be") {
    for (const JointKind kind : {JointKind::ball, JointKind::hinge, JointKind::distance}) {
        for (const double spin_rad_per_s : {5.0, 30.0, 100.0, 250.0}) {
            CAPTURE(static_cast<int>(kind), spin_rad_per_s);
            const auto world = make_rigid_world(make_round(kind, spin_rad_per_s));
            const double energy_J = world->compute_energy_J();
            double off_m = 0.0;
            for (int i = 0; i < 100; ++i) {
                world->step(0.01);
                const Vector3 at = world->state(0).pose_W.position;
                off_m = std::max(off_m, std::abs(at.norm() - kArm_m));
            }
            CHECK(off_m < kPinned_m);
            CHECK(std::abs(world->compute_energy_J() / energy_J - 1.0) < kMostLate);
            const Vector3 at = world->state(0).pose_W.position;
            const double late_rad =
                std::remainder(std::atan2(at.y(), at.x()) - spin_rad_per_s, 2.0 * M_PI);
            CHECK(std::abs(late_rad) < kMostLate * spin_rad_per_s);
            CHECK(world->report().n_in_parts == (spin_rad_per_s > 20.0 ? 1 : 0));
        }
    }
}

TEST_CASE("rigid world parts: about its own axis, or beyond all parts, a spin wins no energy") {
    RigidWorldPlan plan = make_round(JointKind::hinge, 0.0);
    plan.bodies[0].velocity_W = {Vector3::Zero(), {0.0, 0.0, 1000.0}};
    plan.joints[0].anchor_W = {kArm_m, 0.0, 0.05};
    const auto wheel = make_rigid_world(plan);
    wheel->step(0.01);
    CHECK(wheel->report().n_in_parts == 0);
    CHECK(wheel->state(0).velocity_W.angular.z() == Approx(1000.0));
    plan.joints.clear();
    const auto free = make_rigid_world(plan);
    free->step(0.01);
    CHECK(free->report().n_in_parts == 0);
    for (const double spin_rad_per_s : {2000.0, 1.0e5, 1.0e9}) {
        CAPTURE(spin_rad_per_s);
        const auto world = make_rigid_world(make_round(JointKind::ball, spin_rad_per_s));
        const double energy_J = world->compute_energy_J();
        for (int i = 0; i < 50; ++i) {
            world->step(0.01);
            REQUIRE(is_finite(world->state(0)));
        }
        CHECK(world->compute_energy_J() <= 1.01 * energy_J);
    }
}

// An arm of 0.2 m that a motor swings down from level, and a post of 2 cm in its way.
RigidWorldPlan make_swatter(double speed_rad_per_s) {
    RigidWorldPlan plan = plan_awake({plan_box({0.1, 0.005, 0.02}, {0.1, 0.0, 0.0}, 0.2),
                                      plan_wall(BoxShape{{0.01, 0.01, 0.05}}, {0.12, -0.12, 0.0})});
    plan.joints = {{.kind = JointKind::hinge, .body_b = 0, .axis_W = -Vector3::UnitZ()}};
    plan.joints[0].drive = {.motor_speed = speed_rad_per_s, .motor_force = 2.0};
    return plan;
}

TEST_CASE("rigid world parts: contacts and pushes are those of all parts, and of no more") {
    for (const double speed_rad_per_s : {10.0, 30.0, 60.0}) {
        CAPTURE(speed_rad_per_s);
        const auto world = make_rigid_world(make_swatter(speed_rad_per_s));
        double farthest_rad = 0.0;
        double deepest_m = 0.0;
        for (int i = 0; i < 200; ++i) {
            world->step(0.01);
            farthest_rad = std::max(farthest_rad, world->joint_travel(0));
            deepest_m = std::max(deepest_m, world->report().deepest_m);
        }
        // From its inner upper edge to the hinge: 45 degrees, less half the arm's thickness.
        CHECK(farthest_rad < 0.25 * M_PI);
        CHECK(world->joint_travel(0) > 0.6);
        CHECK(deepest_m < 1.0e-3);
        CHECK(world->shape_pose_W(0).position.norm() == Approx(0.1).margin(kPinned_m));
    }
    const auto world = make_rigid_world(make_round(JointKind::hinge, 40.0));
    const double moment = world->inertia(0).moments_kg_m2.x() + 0.2 * kArm_m * kArm_m;
    world->push(0, {Vector3::Zero(), {0.0, 0.0, 0.05}});
    world->step(0.01);
    CHECK(world->report().n_in_parts == 1);
    const double spin = world->state(0).velocity_W.angular.z();
    CHECK(spin == Approx(40.0 + 0.01 * 0.05 / moment).epsilon(3.0e-3));
    world->step(0.01);
    CHECK(world->state(0).velocity_W.angular.z() == Approx(spin).epsilon(3.0e-3));
}

}  // namespace
}  // namespace fulcrum
