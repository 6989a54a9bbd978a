#include "haptics/dynamics/rigid_world.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kHeldMass_kg = 0.5;
constexpr double kHeldRounding =
    1.0e-8;  // relative: hands are rows of the contact problem, whose answer is within 1e-9 m/s

RigidWorldPlan make_held_plan(const Vector3& gravity_W) {
    RigidWorldPlan plan;
    plan.settings.gravity_W = gravity_W;
    plan.settings.sleep_after_s = 0.0;
    plan.bodies = {{.shape = BoxShape{{0.05, 0.05, 0.05}}, .mass_kg = kHeldMass_kg}};
    return plan;
}

// A grip that may give much.
BodyHold make_hold(const Vector3& at_W, const Wrench& push_W, const PushSlopes& slopes) {
    BodyHold hold{.at_W = at_W, .push_W = push_W, .slopes = slopes};
    hold.bounds = {.most_N = 1.0e3, .most_Nm = 1.0e2};
    return hold;
}

std::unique_ptr<RigidWorld> make_world_of(const RigidWorldPlan& plan) {
    return std::move(RigidWorld::create(plan).value());
}

TEST_CASE("rigid world: against a hand that holds it a body is heavier by h^2 k + h b and m") {
    const auto world = make_world_of(make_held_plan(Vector3::Zero()));
    const double h = 0.02;
    const PushSlopes slopes{400.0, 6.0, 0.3, 0.01, 0.05};
    world->hold(0, make_hold(Vector3::Zero(), {{2.0, 0.0, 0.0}, {0.0, 0.0, 0.03}}, slopes));
    world->step(h);
    const double mass_kg = kHeldMass_kg + h * h * 400.0 + h * 6.0 + 0.05;
    const double moment = kHeldMass_kg / 12.0 * 2.0 * 0.01 + h * h * 0.3 + h * 0.01;
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

// p = h F - G (1/m + r^2/I) p.
TEST_CASE("rigid world: an arm turns what is held, and the hand holds the place where it is") {
    const auto world = make_world_of(make_held_plan(Vector3::Zero()));
    const double h = 0.01;
    const double arm_m = 0.04;
    world->hold(0, make_hold({arm_m, 0.0, 0.0}, {{0.0, 1.5, 0.0}, Vector3::Zero()},
                             {800.0, 0.0, 0.0, 0.0, 0.1}));
    world->step(h);
    const double moment = kHeldMass_kg / 12.0 * 2.0 * 0.01;
    const double give = 1.0 / kHeldMass_kg + arm_m * arm_m / moment;
    const double impulse_Ns = h * 1.5 / (1.0 + (h * h * 800.0 + 0.1) * give);
    CHECK(world->state(0).velocity_W.angular.z() ==
          Approx(arm_m * impulse_Ns / moment).epsilon(kHeldRounding));
    CHECK(world->state(0).velocity_W.linear.y() ==
          Approx(impulse_Ns / kHeldMass_kg).epsilon(kHeldRounding));
}

// k far above what steps of 50 ms could follow with the body's own mass: h^2 k / m = 20.
TEST_CASE("rigid world: a body on a stiff spring comes to rest where the spring holds its weight") {
    for (const double h : {0.001, 0.01, 0.05}) {
        const auto world = make_world_of(make_held_plan({0.0, -9.81, 0.0}));
        const double k = 4000.0;
        double highest_m = 0.0;
        for (int i = 0; i < static_cast<int>(6.0 / h) + 1000; ++i) {
            const Vector3& velocity_W = world->state(0).velocity_W.linear;
            const Vector3 at_W = world->shape_pose_W(0).position;
            const Vector3 force_W = -k * at_W - 8.0 * velocity_W;
            world->hold(0, make_hold(at_W, {force_W, Vector3::Zero()}, {k, 8.0, 0.0, 0.0, 0.0}));
            world->step(h);
            highest_m = std::max(highest_m, world->state(0).pose_W.position.y());
        }
        INFO("step " << h);
        CHECK(world->state(0).pose_W.position.y() ==
              Approx(-kHeldMass_kg * 9.81 / k).epsilon(1.0e-3));
        CHECK(highest_m <= 0.0);
    }
}

// A ball of 2 m/s, touched by a hand along its way, hits one of 1 kg.
double hit_while_touched(double mass_kg, double h, double force_N, double most_N) {
    RigidWorldPlan plan;
    plan.settings.gravity_W = Vector3::Zero();
    plan.settings.sleep_after_s = 0.0;
    plan.bodies = {{.shape = SphereShape{0.02},
                    .mass_kg = mass_kg,
                    .pose_W = Pose::at({-0.1, 0.0, 0.0}),
                    .velocity_W = {{2.0, 0.0, 0.0}, Vector3::Zero()}},
                   {.shape = SphereShape{0.02}, .mass_kg = 1.0}};
    const auto world = make_world_of(plan);
    for (int i = 0; i < static_cast<int>(0.3 / h) + 2; ++i) {
        BodyHold hold =
            make_hold(world->shape_pose_W(0).position, {{force_N, 0.0, 0.0}, Vector3::Zero()},
                      {600.0, 5.0, 0.0, 0.0, 0.04});
        hold.bounds = {.along_W = Vector3::UnitX(), .most_N = most_N};
        world->hold(0, hold);
        world->step(h);
    }
    return mass_kg * world->state(0).velocity_W.linear.x() + world->state(1).velocity_W.linear.x();
}

struct Hit {
    double step_s;
    double mass_kg;
};

TEST_CASE("rigid world: what a hand touches hits with its own mass, and no more than hands give") {
    for (const Hit& hit :
         {Hit{0.001, 0.02}, Hit{0.001, 0.2}, Hit{0.01, 0.02}, Hit{0.05, 0.02}, Hit{0.05, 0.2}}) {
        INFO("step " << hit.step_s << ", " << hit.mass_kg << " kg");
        const double before_Ns = 2.0 * hit.mass_kg;
        const double free_Ns = hit_while_touched(hit.mass_kg, hit.step_s, 0.0, 0.0);
        CHECK(std::abs(free_Ns - before_Ns) <= 1.0e-9);
        // In the two steps of the hit it pushes on, as far as it may.
        const double pushed_Ns = hit_while_touched(hit.mass_kg, hit.step_s, 0.0, 0.5) - before_Ns;
        CHECK(std::clamp(pushed_Ns, 0.0, 2.0 * 0.5 * hit.step_s + 1.0e-9) == pushed_Ns);
    }
}

// How fast 20 g are after 0.1 s without support, touched at the side.
double fall_touched(double force_N, double friction_N) {
    RigidWorldPlan plan = make_held_plan({0.0, -9.81, 0.0});
    plan.bodies[0].mass_kg = 0.02;
    const auto world = make_world_of(plan);
    for (int i = 0; i < 100; ++i) {
        BodyHold hold =
            make_hold(world->shape_pose_W(0).position, {{force_N, 0.0, 0.0}, Vector3::Zero()},
                      {600.0, 5.0, 0.0, 0.0, 0.04});
        hold.bounds = {.along_W = Vector3::UnitX(), .friction_N = friction_N, .most_N = 1.0};
        world->hold(0, hold);
        world->step(0.001);
    }
    return -world->state(0).velocity_W.linear.y();
}

TEST_CASE("rigid world: a body falls past a hand that touches its side, but for its friction") {
    CHECK(fall_touched(1.0e-3, 0.0) == Approx(0.981).epsilon(1.0e-9));
    CHECK(fall_touched(1.0, 0.0) == Approx(0.981).epsilon(1.0e-9));
    // What friction may hold it may take: m g - 0.6 mN.
    CHECK(fall_touched(1.0e-3, 0.6e-3) == Approx(0.1 * (9.81 - 0.6e-3 / 0.02)).epsilon(1.0e-9));
}

TEST_CASE("rigid world: a touch never draws a body that goes") {
    const auto world = make_world_of(make_held_plan({9.81, 0.0, 0.0}));
    for (int i = 0; i < 10; ++i) {
        BodyHold hold =
            make_hold(world->shape_pose_W(0).position, {{1.0e-3, 0.0, 0.0}, Vector3::Zero()},
                      {4000.0, 50.0, 0.0, 0.0, 0.1});
        hold.bounds = {.along_W = Vector3::UnitX(), .most_N = 1.0};
        world->hold(0, hold);
        world->step(0.01);
    }
    CHECK(world->state(0).velocity_W.linear.x() == Approx(0.981).epsilon(1.0e-9));
}

// A hand that goes along below a body that falls, and presses nothing: the spring alone meets what it gains within the step.
TEST_CASE("rigid world: what a touch without force goes along with falls as if there were none") {
    RigidWorldPlan plan = make_held_plan({0.0, -9.81, 0.0});
    plan.bodies[0].mass_kg = 0.2;
    const auto world = make_world_of(plan);
    for (int i = 0; i < 100; ++i) {
        const double speed = world->state(0).velocity_W.linear.y();
        BodyHold hold = make_hold(world->shape_pose_W(0).position,
                                  {{0.0, 0.001 * 600.0 * speed, 0.0}, Vector3::Zero()},
                                  {600.0, 5.0, 0.0, 0.0, 0.04});
        hold.bounds = {.along_W = Vector3::UnitY(), .most_N = 3.0};
        world->hold(0, hold);
        world->step(0.001);
    }
    const double spring_kg = 1.0e-6 * 600.0;
    CHECK(world->state(0).velocity_W.linear.y() ==
          Approx(-0.981 * 0.2 / (0.2 + spring_kg)).epsilon(1.0e-6));
}

TEST_CASE("rigid world: a hand gives no more than it may feel, whatever way it is pulled") {
    const double h = 0.01;
    const PushSlopes slopes{4000.0, 50.0, 0.0, 0.0, 2.0};
    for (const Vector3& pull_N : {Vector3(10.0, 10.0, 10.0), Vector3(0.0, -12.0, 5.0),
                                  Vector3(30.0, 0.0, 0.0), Vector3(-7.0, 8.0, 0.1)}) {
        // A grip, and a push whose friction bears 2 N across.
        const auto gripped = make_world_of(make_held_plan(Vector3::Zero()));
        BodyHold grip = make_hold(Vector3::Zero(), {}, slopes);
        grip.bounds = {.most_N = 3.0, .most_Nm = 1.0};
        gripped->hold(0, grip);
        gripped->push(0, {pull_N, Vector3::Zero()});
        gripped->step(h);
        const auto given_N = [&](const RigidWorld& world) -> Vector3 {
            return kHeldMass_kg / h * world.state(0).velocity_W.linear - pull_N;
        };
        CHECK(given_N(*gripped).norm() == Approx(3.0).epsilon(1.0e-6));
        CHECK(given_N(*gripped).normalized().dot(-pull_N.normalized()) > 0.9);
        const auto pushed = make_world_of(make_held_plan(Vector3::Zero()));
        BodyHold push = make_hold(Vector3::Zero(), {{0.0, 2.9, 0.0}, Vector3::Zero()}, slopes);
        push.bounds = {.along_W = Vector3::UnitY(), .friction_N = 2.0, .most_N = 3.0};
        pushed->hold(0, push);
        pushed->push(0, {pull_N, Vector3::Zero()});
        pushed->step(h);
        const Vector3 pushed_N = given_N(*pushed);
        CHECK(pushed_N.norm() <= 3.0 * (1.0 + 1.0e-6));
        CHECK(std::hypot(pushed_N.x(), pushed_N.z()) <= 2.0 * (1.0 + 1.0e-6));
        CHECK(pushed_N.y() >= -1.0e-6);
    }
}

TEST_CASE("rigid world: a push is along its direction, however long that is written") {
    Vector3 velocity_W = Vector3::Zero();
    for (const double length : {1.0, 1.0e-3, 7.0}) {
        const auto world = make_world_of(make_held_plan({0.0, -9.81, 0.0}));
        BodyHold hold = make_hold({0.01, 0.0, 0.0}, {{1.0, 3.0, 0.5}, Vector3::Zero()},
                                  {600.0, 5.0, 0.0, 0.0, 0.04});
        hold.bounds = {
            .along_W = length * Vector3(0.6, 0.8, 0.0), .friction_N = 0.5, .most_N = 9.0};
        world->hold(0, hold);
        world->step(0.01);
        const Vector3& now_W = world->state(0).velocity_W.linear;
        velocity_W = length == 1.0 ? now_W : velocity_W;
        CHECK((now_W - velocity_W).norm() < 1.0e-12);
    }
    CHECK(velocity_W.norm() > 0.01);
}

TEST_CASE(
    "rigid world: a hold that is no number, or falls where the body gives way, is passed over") {
    const auto world = make_world_of(make_held_plan(Vector3::Zero()));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Wrench push{{1.0, 0.0, 0.0}, Vector3::Zero()};
    const BodyHold good = make_hold(Vector3::Zero(), push, {400.0, 6.0, 0.3, 0.01, 0.05});
    const auto spoil = [&](auto change) {
        BodyHold hold = good;
        change(hold);
        world->hold(0, hold);
    };
    spoil([&](BodyHold& hold) { hold.at_W.setConstant(nan); });
    spoil([&](BodyHold& hold) { hold.at_W.x() = 1.0e160; });
    spoil([&](BodyHold& hold) { hold.push_W.force.setConstant(nan); });
    spoil([&](BodyHold& hold) { hold.push_W.torque.setConstant(nan); });
    spoil([&](BodyHold& hold) { hold.slopes.stiffness_N_per_m = -1.0; });
    spoil([&](BodyHold& hold) { hold.slopes.damping_Ns_per_m = nan; });
    spoil([&](BodyHold& hold) { hold.bounds.along_W.setConstant(nan); });
    spoil([&](BodyHold& hold) { hold.bounds.most_N = std::numeric_limits<double>::infinity(); });
    spoil([&](BodyHold& hold) { hold.bounds.friction_N = -1.0; });
    world->hold(7, good);
    world->step(0.001);
    CHECK(world->state(0).velocity_W.linear.norm() == 0.0);
    // Nothing of it stays: the next push moves the body's own mass.
    world->push(0, push);
    world->step(0.001);
    CHECK(world->report().n_dropped == 0);
    CHECK(world->state(0).velocity_W.linear.x() ==
          Approx(0.001 / kHeldMass_kg).epsilon(kHeldRounding));
}

TEST_CASE("rigid world: of more hands than there is room for the rest is counted, in that step") {
    const auto world = make_world_of(make_held_plan(Vector3::Zero()));
    const Wrench push{{1.0, 0.0, 0.0}, Vector3::Zero()};
    for (int i = 0; i < 6; ++i) {
        world->hold(0, make_hold(Vector3::Zero(), push, {}));
    }
    world->step(0.001);
    CHECK(world->report().n_dropped == 2);
    CHECK(world->state(0).velocity_W.linear.x() ==
          Approx(0.004 / kHeldMass_kg).epsilon(kHeldRounding));
    world->step(0.001);
    CHECK(world->report().n_dropped == 0);
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
