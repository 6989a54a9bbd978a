#include "tests/support/rigid_worlds.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kArm_m = 0.1;
// What a solver of 1e-9 m/s and rows that look for 1e-7 m leave.
constexpr double kPinned_m = 1.0e-6;

// Of speeds and energy: velocities are those of chords, which 0.2 rad a part has (w h)^2 / 6 of.
constexpr double kMostLate = 0.04 / 6.0;

// A ball on a weightless arm goes round the origin in the xy plane.
RigidWorldPlan make_round(JointKind kind, double spin_rad_per_s) {
    RigidWorldPlan plan;
    plan.settings.gravity_W.setZero();
    plan.settings.sleep_after_s = 0.0;
    const bool is_rod = kind == JointKind::distance;
    plan.bodies.push_back({.shape = SphereShape{0.02},
                           .mass_kg = 0.2,
                           .pose_W = Pose::at({kArm_m, 0.0, 0.0}),
                           .velocity_W = {{0.0, spin_rad_per_s * kArm_m, 0.0},
                                          {0.0, 0.0, is_rod ? 0.0 : spin_rad_per_s}}});
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
            constexpr double kStep_s = 0.01;
            double off_m = 0.0;
            for (int i = 0; i < 100; ++i) {
                world->step(kStep_s);
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

TEST_CASE("rigid world parts: what spins about its joint's own axis, or has none, goes in one") {
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
}

TEST_CASE("rigid world parts: a spin beyond all parts stays finite and wins no energy") {
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
    RigidWorldPlan plan;
    plan.settings.sleep_after_s = 0.0;
    plan.bodies = {{.shape = BoxShape{{0.1, 0.005, 0.02}},
                    .mass_kg = 0.2,
                    .pose_W = Pose::at({0.1, 0.0, 0.0})},
                   {.shape = BoxShape{{0.01, 0.01, 0.05}},
                    .role = BodyRole::stays,
                    .pose_W = Pose::at({0.12, -0.12, 0.0})}};
    plan.joints = {{.kind = JointKind::hinge, .body_b = 0, .axis_W = -Vector3::UnitZ()}};
    plan.joints[0].drive = {.motor_speed = speed_rad_per_s, .motor_force = 2.0};
    return plan;
}

TEST_CASE("rigid world parts: contacts are those of each part: what is swung stops at a post") {
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
}

TEST_CASE("rigid world parts: a push acts in all parts of a step, and no longer") {
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
