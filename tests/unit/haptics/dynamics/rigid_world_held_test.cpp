#include "haptics/dynamics/rigid_world.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kHeldMass_kg = 0.5;
constexpr double kHeldRounding = 1.0e-12;

RigidWorldPlan make_held_plan(const Vector3& gravity_W) {
    RigidWorldPlan plan;
    plan.settings.gravity_W = gravity_W;
    plan.settings.sleep_after_s = 0.0;
    plan.bodies = {{.shape = BoxShape{{0.05, 0.05, 0.05}}, .mass_kg = kHeldMass_kg}};
    return plan;
}

TEST_CASE("rigid world: a body that a hand holds is heavier by 2 (h^2 k + h b) and the late mass") {
    auto world = std::move(RigidWorld::create(make_held_plan(Vector3::Zero())).value());
    const double h = 0.02;
    const PushSlopes slopes{400.0, 6.0, 0.3, 0.01, 0.05};
    world->hold(0, Vector3::Zero(), {{2.0, 0.0, 0.0}, {0.0, 0.0, 0.03}}, slopes);
    world->step(h);
    const double mass_kg = kHeldMass_kg + 2.0 * (h * h * 400.0 + h * 6.0) + 0.05;
    const double moment = kHeldMass_kg / 12.0 * 2.0 * 0.01 + 2.0 * (h * h * 0.3 + h * 0.01);
    CHECK(world->state(0).velocity_W.linear.x() ==
          Approx(2.0 * h / mass_kg).epsilon(kHeldRounding));
    CHECK(world->state(0).velocity_W.angular.z() ==
          Approx(0.03 * h / moment).epsilon(kHeldRounding));
    // Once let go it has its own mass again.
    world->push(0, {{2.0, 0.0, 0.0}, Vector3::Zero()});
    world->step(h);
    CHECK(world->state(0).velocity_W.linear.x() ==
          Approx(2.0 * h / mass_kg + 2.0 * h / kHeldMass_kg).epsilon(kHeldRounding));
}

TEST_CASE("rigid world: an arm turns what is held, and makes turning heavier by its square") {
    auto world = std::move(RigidWorld::create(make_held_plan(Vector3::Zero())).value());
    const double h = 0.01;
    const double arm_m = 0.04;
    world->hold(0, {arm_m, 0.0, 0.0}, {{0.0, 1.5, 0.0}, Vector3::Zero()},
                {800.0, 0.0, 0.0, 0.0, 0.1});
    world->step(h);
    const double moment =
        kHeldMass_kg / 12.0 * 2.0 * 0.01 + arm_m * arm_m * (2.0 * h * h * 800.0 + 0.1);
    CHECK(world->state(0).velocity_W.angular.z() ==
          Approx(1.5 * arm_m * h / moment).epsilon(kHeldRounding));
}

// k far above what steps of 50 ms could follow with the body's own mass: h^2 k / m = 20.
TEST_CASE("rigid world: a body on a stiff spring comes to rest where the spring holds its weight") {
    for (const double h : {0.001, 0.01, 0.05}) {
        auto world = std::move(RigidWorld::create(make_held_plan({0.0, -9.81, 0.0})).value());
        const double k = 4000.0;
        double highest_m = 0.0;
        for (int i = 0; i < static_cast<int>(6.0 / h) + 1000; ++i) {
            const Vector3 at_W = world->shape_pose_W(0).position;
            const Vector3 force_W = -k * at_W - 8.0 * world->state(0).velocity_W.linear;
            world->hold(0, at_W, {force_W, Vector3::Zero()}, {k, 8.0, 0.0, 0.0, 0.0});
            world->step(h);
            highest_m = std::max(highest_m, world->state(0).pose_W.position.y());
        }
        INFO("step " << h);
        CHECK(world->state(0).pose_W.position.y() ==
              Approx(-kHeldMass_kg * 9.81 / k).epsilon(1.0e-3));
        CHECK(highest_m <= 0.0);
    }
}

TEST_CASE(
    "rigid world: a hold that is no number, or falls where the body gives way, is passed over") {
    auto world = std::move(RigidWorld::create(make_held_plan(Vector3::Zero())).value());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Wrench push{{1.0, 0.0, 0.0}, Vector3::Zero()};
    world->hold(0, Vector3::Constant(nan), push, {});
    world->hold(0, Vector3::Zero(), {Vector3::Constant(nan), Vector3::Zero()}, {});
    world->hold(0, Vector3::Zero(), push, {-1.0, 0.0, 0.0, 0.0, 0.0});
    world->hold(0, Vector3::Zero(), push, {0.0, nan, 0.0, 0.0, 0.0});
    world->hold(7, Vector3::Zero(), push, {});
    world->step(0.001);
    CHECK(world->state(0).velocity_W.linear.norm() == 0.0);
    // Nothing of it stays: the next push moves the body's own mass.
    const PushSlopes slopes{400.0, 6.0, 0.3, 0.01, 0.05};
    world->hold(0, Vector3::Zero(), {Vector3::Constant(nan), Vector3::Zero()}, slopes);
    world->hold(0, Vector3::Zero(), {Vector3::Zero(), Vector3::Constant(nan)}, slopes);
    world->hold(0, {1.0e160, 0.0, 0.0}, push, slopes);
    world->push(0, push);
    world->step(0.001);
    CHECK(world->report().n_dropped == 0);
    CHECK(world->state(0).velocity_W.linear.x() ==
          Approx(0.001 / kHeldMass_kg).epsilon(kHeldRounding));
}

TEST_CASE("rigid world: a body that is taken out falls no more, and what lay on it does") {
    RigidWorldPlan plan;
    plan.bodies = {{.role = BodyRole::ground},
                   {.shape = BoxShape{{0.05, 0.05, 0.05}}, .pose_W = Pose::at({0.0, 0.05, 0.0})},
                   {.shape = BoxShape{{0.05, 0.05, 0.05}}, .pose_W = Pose::at({0.0, 0.15, 0.0})}};
    auto world = std::move(RigidWorld::create(plan).value());
    for (int i = 0; i < 1500; ++i) {
        world->step(0.001);
    }
    REQUIRE(world->is_asleep(2));
    world->set_present(1, false);
    for (int i = 0; i < 1000; ++i) {
        world->step(0.001);
    }
    CHECK(world->state(1).pose_W.position.y() == Approx(0.05).margin(1.0e-4));
    CHECK(world->state(2).pose_W.position.y() == Approx(0.05).margin(1.0e-4));
    // Where it comes back the other one is: they part again.
    world->place(1, Pose::at({0.5, 0.05, 0.0}), {});
    world->set_present(1, true);
    world->push(1, {{0.0, 20.0, 0.0}, Vector3::Zero()});
    world->step(0.001);
    CHECK(world->state(1).velocity_W.linear.y() > 0.0);
}

}  // namespace
}  // namespace fulcrum
