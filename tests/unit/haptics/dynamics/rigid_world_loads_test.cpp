#include "haptics/dynamics/rigid_world.h"
#include "tests/support/rigid_worlds.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace fulcrum {
namespace {

TEST_CASE("rigid world: what hangs from a hook that is taken out or moved wakes") {
    // A box that hangs asleep from another one, which does not move.
    const auto hang = [] {
        RigidWorldPlan plan;
        plan.bodies = {plan_wall(BoxShape{Vector3::Constant(0.05)}, {0.0, 2.0, 0.0}),
                       plan_cube(0.05, {0.0, 1.7, 0.0})};
        plan.joints = {
            {.kind = JointKind::ball, .body_a = 0, .body_b = 1, .anchor_W = {0.0, 2.0, 0.0}}};
        auto world = make_rigid_world(plan);
        run(*world, 2.0);
        REQUIRE(world->is_asleep(1));
        return world;
    };
    const auto hidden = hang();
    hidden->set_present(0, false);
    const auto moved = hang();
    moved->place(0, Pose::at({0.1, 2.0, 0.0}), {});
    run(*hidden, 0.5);
    run(*moved, 0.5);
    CHECK(hidden->state(1).pose_W.position.y() < 1.7 - 1.0);
    CHECK(std::abs(moved->state(1).pose_W.position.x()) > 1.0e-3);
}

// A double pendulum: after each step of a millisecond one that is hardly any.
TEST_CASE("rigid world: a link that carries a load turns about itself as freely as without it") {
    // 10 g under 5 kg, turned about the vertical that both hang in: w = torque t / I.
    constexpr double kTorque_Nm = 1.0e-5;
    for (const double dt_s : {1.0e-3, 2.0e-2}) {
        CAPTURE(dt_s);
        RigidWorldPlan plan =
            plan_awake({plan_body(CapsuleShape{0.005, 0.05}, Pose::at({0.0, -0.055, 0.0}), 0.01),
                        plan_ball(0.02, {0.0, -0.2, 0.0}, 5.0)});
        plan.settings.most_pairs = 4;
        plan.joints = {
            {.kind = JointKind::hinge,
             .body_b = 0,
             .drive = {.motor_speed = 100.0, .motor_force = kTorque_Nm}},
            {.kind = JointKind::ball, .body_a = 0, .body_b = 1, .anchor_W = {0.0, -0.11, 0.0}}};
        const auto world = make_rigid_world(plan);
        for (int i = 0; i < static_cast<int>(std::lround(0.1 / dt_s)); ++i) {
            world->step(dt_s);
        }
        const double moment_kg_m2 = world->inertia(0).moments_kg_m2.minCoeff();
        CHECK(world->state(0).velocity_W.angular.y() ==
              Approx(kTorque_Nm * 0.1 / moment_kg_m2).epsilon(1.0e-3));
    }
}

TEST_CASE("rigid world: a quaternion of any length turns a body, one of none is refused") {
    Pose twice = Pose::at({1.0, 2.0, 3.0});
    twice.orientation = Quaternion(std::sqrt(2.0), 0.0, 0.0, std::sqrt(2.0));  // of length 2
    const std::vector<Vector3> corners{
        {0.05, 0.0, 0.0}, {-0.05, 0.0, 0.05}, {-0.05, 0.0, -0.05}, {0.0, 0.08, 0.0}};
    RigidWorldPlan plan;
    plan.settings.most_pairs = 4;
    plan.bodies = {plan_body(make_hull_shape(corners).value(), twice)};
    const auto world = make_rigid_world(plan);
    const auto check_pose = [&] {
        const Pose pose = world->shape_pose_W(0);
        CHECK((pose.position - twice.position).norm() < 1.0e-14);
        CHECK((pose.orientation.coeffs() - 0.5 * twice.orientation.coeffs()).norm() < 1.0e-14);
    };
    check_pose();
    Pose lost = twice;
    lost.orientation.coeffs().setZero();
    for (const Pose& pose : {lost, twice}) {
        world->place(0, pose, {});
        check_pose();
    }
    plan.bodies[0].pose_W = lost;
    CHECK(RigidWorld::create(plan).error().message.find("body 0") != std::string::npos);
}

TEST_CASE("rigid world: short steps between others give jointed bodies no energy") {
    for (const double short_s : {1.0e-6, 1.0e-8}) {
        CAPTURE(short_s);
        RigidWorldPlan plan =
            plan_awake({plan_ball(0.02, {0.2, 0.0, 0.0}), plan_ball(0.02, {0.4, 0.0, 0.0})});
        plan.joints = {
            {.kind = JointKind::ball, .body_b = 0, .anchor_W = {0.0, 0.0, 0.0}},
            {.kind = JointKind::ball, .body_a = 0, .body_b = 1, .anchor_W = {0.2, 0.0, 0.0}}};
        const auto world = make_rigid_world(plan);
        const double before_J = world->compute_energy_J();
        double worst_J = 0.0;
        for (int i = 0; i < 2000; ++i) {
            world->step(0.001);
            world->step(short_s);
            worst_J = std::max(worst_J, world->compute_energy_J() - before_J);
        }
        CHECK(worst_J < 0.05);
    }
}

}  // namespace
}  // namespace fulcrum
