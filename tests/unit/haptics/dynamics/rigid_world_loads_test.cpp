#include "haptics/dynamics/rigid_world.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kLoadedMass_kg = 0.5;
constexpr double kLoadedRounding = 1.0e-12;

RigidWorldPlan make_loaded_plan() {
    RigidWorldPlan plan;
    plan.settings.gravity_W = Vector3::Zero();
    plan.settings.sleep_after_s = 0.0;
    plan.bodies = {{.shape = BoxShape{{0.05, 0.05, 0.05}}, .mass_kg = kLoadedMass_kg}};
    return plan;
}

TEST_CASE("rigid world: what is pushed while it is away, or before it is placed, stays at rest") {
    auto world = std::move(RigidWorld::create(make_loaded_plan()).value());
    const Wrench push{{9.0, 0.0, 0.0}, {0.0, 0.1, 0.0}};
    BodyHold hold{.at_W = {0.0, 0.05, 0.0}, .push_W = push};
    hold.slopes = {400.0, 6.0, 0.3, 0.01, 0.05};
    hold.bounds = {.most_N = 10.0, .most_Nm = 1.0};
    const auto load = [&] {
        world->push(0, push);
        world->hold(0, hold);
    };
    const auto is_at_rest = [&] {
        world->step(0.001);
        const Twist& velocity_W = world->state(0).velocity_W;
        return velocity_W.linear.norm() == 0.0 && velocity_W.angular.norm() == 0.0;
    };
    load();
    world->set_present(0, false);
    for (int i = 0; i < 100; ++i) {
        load();
        world->step(0.001);
    }
    world->set_present(0, true);
    CHECK(is_at_rest());
    load();
    world->place(0, Pose::at({1.0, 0.0, 0.0}), {});
    CHECK(is_at_rest());
    // Nor is it heavier than it is.
    world->push(0, {{9.0, 0.0, 0.0}, Vector3::Zero()});
    world->step(0.001);
    CHECK(world->state(0).velocity_W.linear.x() ==
          Approx(9.0 * 0.001 / kLoadedMass_kg).epsilon(kLoadedRounding));
}

// A box that hangs asleep from another one, which does not move.
std::unique_ptr<RigidWorld> make_hung_box() {
    RigidWorldPlan plan;
    plan.bodies = {{.shape = BoxShape{{0.05, 0.05, 0.05}},
                    .role = BodyRole::stays,
                    .pose_W = Pose::at({0.0, 2.0, 0.0})},
                   {.shape = BoxShape{{0.05, 0.05, 0.05}}, .pose_W = Pose::at({0.0, 1.7, 0.0})}};
    plan.joints = {
        {.kind = JointKind::ball, .body_a = 0, .body_b = 1, .anchor_W = {0.0, 2.0, 0.0}}};
    auto world = std::move(RigidWorld::create(plan).value());
    for (int i = 0; i < 2000; ++i) {
        world->step(0.001);
    }
    REQUIRE(world->is_asleep(1));
    return world;
}

TEST_CASE("rigid world: what hangs from a hook that is taken out or moved wakes") {
    auto hidden = make_hung_box();
    hidden->set_present(0, false);
    auto moved = make_hung_box();
    moved->place(0, Pose::at({0.1, 2.0, 0.0}), {});
    for (int i = 0; i < 500; ++i) {
        hidden->step(0.001);
        moved->step(0.001);
    }
    CHECK(hidden->state(1).pose_W.position.y() < 1.7 - 1.0);
    CHECK(std::abs(moved->state(1).pose_W.position.x()) > 1.0e-3);
}

// A double pendulum: after each step of a millisecond one that is hardly any.
TEST_CASE("rigid world: a link that carries a load turns about itself as freely as without it") {
    // 10 g under 5 kg, turned about the vertical that both hang in: w = torque t / I.
    constexpr double kTorque_Nm = 1.0e-5;
    for (const double dt_s : {1.0e-3, 2.0e-2}) {
        RigidWorldPlan plan;
        plan.settings.sleep_after_s = 0.0;
        plan.settings.most_pairs = 4;
        plan.bodies = {
            {.shape = CapsuleShape{0.005, 0.05},
             .mass_kg = 0.01,
             .pose_W = Pose::at({0.0, -0.055, 0.0})},
            {.shape = SphereShape{0.02}, .mass_kg = 5.0, .pose_W = Pose::at({0.0, -0.2, 0.0})}};
        JointPlan hook{.kind = JointKind::hinge, .body_b = 0};
        hook.drive.motor_speed = 100.0;
        hook.drive.motor_force = kTorque_Nm;
        plan.joints = {
            hook,
            {.kind = JointKind::ball, .body_a = 0, .body_b = 1, .anchor_W = {0.0, -0.11, 0.0}}};
        auto world = RigidWorld::create(plan);
        REQUIRE(world);
        for (int i = 0; i < static_cast<int>(std::lround(0.1 / dt_s)); ++i) {
            (*world)->step(dt_s);
        }
        const double moment_kg_m2 = (*world)->inertia(0).moments_kg_m2.minCoeff();
        CHECK((*world)->state(0).velocity_W.angular.y() ==
              Approx(kTorque_Nm * 0.1 / moment_kg_m2).epsilon(1.0e-3));
    }
}

TEST_CASE("rigid world: a quaternion of any length turns a body, one of none is refused") {
    RigidWorldPlan plan;
    plan.settings.most_pairs = 4;
    Pose twice = Pose::at({1.0, 2.0, 3.0});
    twice.orientation = Quaternion(std::sqrt(2.0), 0.0, 0.0, std::sqrt(2.0));  // of length 2
    const std::vector<Vector3> corners{
        {0.05, 0.0, 0.0}, {-0.05, 0.0, 0.05}, {-0.05, 0.0, -0.05}, {0.0, 0.08, 0.0}};
    plan.bodies = {{.shape = make_hull_shape(corners).value(), .pose_W = twice}};
    auto world = RigidWorld::create(plan);
    REQUIRE(world);
    const auto check_pose = [&] {
        const Pose pose = (*world)->shape_pose_W(0);
        CHECK((pose.position - twice.position).norm() < 1.0e-14);
        CHECK((pose.orientation.coeffs() - 0.5 * twice.orientation.coeffs()).norm() < 1.0e-14);
    };
    check_pose();
    Pose lost = twice;
    lost.orientation.coeffs().setZero();
    (*world)->place(0, lost, {});
    check_pose();
    (*world)->place(0, twice, {});
    check_pose();
    plan.bodies[0].pose_W = lost;
    CHECK(RigidWorld::create(plan).error().message.find("body 0") != std::string::npos);
}

TEST_CASE("rigid world: short steps between others give jointed bodies no energy") {
    for (const double short_s : {1.0e-6, 1.0e-8}) {
        RigidWorldPlan plan;
        plan.settings.sleep_after_s = 0.0;
        plan.bodies = {{.shape = SphereShape{0.02}, .pose_W = Pose::at({0.2, 0.0, 0.0})},
                       {.shape = SphereShape{0.02}, .pose_W = Pose::at({0.4, 0.0, 0.0})}};
        plan.joints = {
            {.kind = JointKind::ball, .body_b = 0, .anchor_W = {0.0, 0.0, 0.0}},
            {.kind = JointKind::ball, .body_a = 0, .body_b = 1, .anchor_W = {0.2, 0.0, 0.0}}};
        auto world = std::move(RigidWorld::create(plan).value());
        const double before_J = world->compute_energy_J();
        double worst_J = 0.0;
        for (int i = 0; i < 2000; ++i) {
            world->step(0.001);
            world->step(short_s);
            worst_J = std::max(worst_J, world->compute_energy_J() - before_J);
        }
        INFO("short steps of " << short_s);
        CHECK(worst_J < 0.05);
    }
}

}  // namespace
}  // namespace fulcrum
