#include "haptics/dynamics/rigid_world.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"
#include "tests/support/rigid_worlds.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace fulcrum {
namespace {

constexpr double kHeldMass_kg = 0.5;
constexpr double kHeldRounding =
    1.0e-8;  // relative: hands are rows of the contact problem, whose answer is within 1e-9 m/s
const Vector3 kDown(0.0, -9.81, 0.0);
const PushSlopes kHand{600.0, 5.0, 0.0, 0.0, 0.04};

// A grip that may give much.
BodyHold make_hold(const Vector3& at_W, const Wrench& push_W, const PushSlopes& slopes) {
    BodyHold hold{.at_W = at_W, .push_W = push_W, .slopes = slopes};
    hold.bounds = {.most_N = 1.0e3, .most_Nm = 1.0e2};
    return hold;
}

// A touch where the body is, along an axis.
BodyHold make_touch(const RigidWorld& world, const Vector3& force_W, const PushSlopes& slopes,
                    const Vector3& along_W, double most_N, double friction_N = 0.0) {
    BodyHold hold = make_hold(world.shape_pose_W(0).position, {force_W, Vector3::Zero()}, slopes);
    hold.bounds = {.along_W = along_W, .friction_N = friction_N, .most_N = most_N};
    return hold;
}

// One cube.
std::unique_ptr<RigidWorld> make_held(const Vector3& gravity_W = Vector3::Zero(),
                                      double mass_kg = kHeldMass_kg) {
    RigidWorldPlan plan = plan_awake({plan_cube(0.05, Vector3::Zero(), mass_kg)});
    plan.settings.gravity_W = gravity_W;
    return make_rigid_world(plan);
}

TEST_CASE("rigid world: against a hand that holds it a body is heavier by h^2 k + h b and m") {
    const auto world = make_held();
    const double h = 0.02;
    const PushSlopes slopes{400.0, 6.0, 0.3, 0.01, 0.05};
    world->hold(0, make_hold(Vector3::Zero(), {{2.0, 0.0, 0.0}, {0.0, 0.0, 0.03}}, slopes));
    world->step(h);
    const double mass_kg = kHeldMass_kg + h * h * 400.0 + h * 6.0 + 0.05;
    const double moment = kHeldMass_kg / 12.0 * 2.0 * 0.01 + h * h * 0.3 + h * 0.01;
    const Twist& velocity_W = world->state(0).velocity_W;
    CHECK(velocity_W.linear.x() == Approx(2.0 * h / mass_kg).epsilon(kHeldRounding));
    CHECK(velocity_W.angular.z() == Approx(0.03 * h / moment).epsilon(kHeldRounding));
    // Once let go it has its own mass again.
    world->push(0, {{2.0, 0.0, 0.0}, Vector3::Zero()});
    world->step(h);
    CHECK(velocity_W.linear.x() ==
          Approx(2.0 * h / mass_kg + 2.0 * h / kHeldMass_kg).epsilon(kHeldRounding));
}

// p = h F - G (1/m + r^2/I) p.
TEST_CASE("rigid world: an arm turns what is held, and the hand holds the place where it is") {
    const auto world = make_held();
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
        const auto world = make_held(kDown);
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
double hit_while_touched(double mass_kg, double h, double most_N) {
    const auto world = make_rigid_world(
        plan_weightless({plan_ball(0.02, {-0.1, 0.0, 0.0}, mass_kg, {2.0, 0.0, 0.0}),
                         plan_ball(0.02, Vector3::Zero(), 1.0)}));
    for (int i = 0; i < static_cast<int>(0.3 / h) + 2; ++i) {
        world->hold(0, make_touch(*world, Vector3::Zero(), kHand, Vector3::UnitX(), most_N));
        world->step(h);
    }
    return mass_kg * world->state(0).velocity_W.linear.x() + world->state(1).velocity_W.linear.x();
}

TEST_CASE("rigid world: what a hand touches hits with its own mass, and no more than hands give") {
    struct Hit {
        double step_s, mass_kg;
    };
    for (const Hit& hit :
         {Hit{0.001, 0.02}, Hit{0.001, 0.2}, Hit{0.01, 0.02}, Hit{0.05, 0.02}, Hit{0.05, 0.2}}) {
        CAPTURE(hit.step_s, hit.mass_kg);
        const double before_Ns = 2.0 * hit.mass_kg;
        const double free_Ns = hit_while_touched(hit.mass_kg, hit.step_s, 0.0);
        CHECK(std::abs(free_Ns - before_Ns) <= 1.0e-9);
        // In the two steps of the hit it pushes on, as far as it may.
        const double pushed_Ns = hit_while_touched(hit.mass_kg, hit.step_s, 0.5) - before_Ns;
        CHECK(std::clamp(pushed_Ns, 0.0, 2.0 * 0.5 * hit.step_s + 1.0e-9) == pushed_Ns);
    }
}

// How fast 20 g are after 0.1 s without support, touched at the side.
double fall_touched(double force_N, double friction_N) {
    const auto world = make_held(kDown, 0.02);
    for (int i = 0; i < 100; ++i) {
        world->hold(
            0, make_touch(*world, {force_N, 0.0, 0.0}, kHand, Vector3::UnitX(), 1.0, friction_N));
        world->step(0.001);
    }
    return -world->state(0).velocity_W.linear.y();
}

TEST_CASE("rigid world: a body falls past a hand at its side, and a touch never draws it") {
    CHECK(fall_touched(1.0e-3, 0.0) == Approx(0.981).epsilon(1.0e-9));
    CHECK(fall_touched(1.0, 0.0) == Approx(0.981).epsilon(1.0e-9));
    // What friction may hold it may take: m g - 0.6 mN.
    CHECK(fall_touched(1.0e-3, 0.6e-3) == Approx(0.1 * (9.81 - 0.6e-3 / 0.02)).epsilon(1.0e-9));
    const auto world = make_held({9.81, 0.0, 0.0});
    for (int i = 0; i < 10; ++i) {
        world->hold(0, make_touch(*world, {1.0e-3, 0.0, 0.0}, {4000.0, 50.0, 0.0, 0.0, 0.1},
                                  Vector3::UnitX(), 1.0));
        world->step(0.01);
    }
    CHECK(world->state(0).velocity_W.linear.x() == Approx(0.981).epsilon(1.0e-9));
}

// A hand that goes along below a body that falls, and presses nothing: the spring alone meets what it gains within the step.
TEST_CASE("rigid world: what a touch without force goes along with falls as if there were none") {
    const auto world = make_held(kDown, 0.2);
    for (int i = 0; i < 100; ++i) {
        const Vector3 met_W(0.0, 0.001 * 600.0 * world->state(0).velocity_W.linear.y(), 0.0);
        world->hold(0, make_touch(*world, met_W, kHand, Vector3::UnitY(), 3.0));
        world->step(0.001);
    }
    const double spring_kg = 1.0e-6 * 600.0;
    CHECK(world->state(0).velocity_W.linear.y() ==
          Approx(-0.981 * 0.2 / (0.2 + spring_kg)).epsilon(1.0e-6));
}

TEST_CASE("rigid world: a hand gives no more than it may feel, along its direction") {
    const double h = 0.01;
    const PushSlopes slopes{4000.0, 50.0, 0.0, 0.0, 2.0};
    for (const Vector3& pull_N : {Vector3(10.0, 10.0, 10.0), Vector3(0.0, -12.0, 5.0),
                                  Vector3(30.0, 0.0, 0.0), Vector3(-7.0, 8.0, 0.1)}) {
        const auto find_given_N = [&](const BodyHold& hold) {
            const auto world = make_held();
            world->hold(0, hold);
            world->push(0, {pull_N, Vector3::Zero()});
            world->step(h);
            return Vector3(kHeldMass_kg / h * world->state(0).velocity_W.linear - pull_N);
        };
        // A grip, and a push whose friction bears 2 N across.
        BodyHold grip = make_hold(Vector3::Zero(), {}, slopes);
        grip.bounds = {.most_N = 3.0, .most_Nm = 1.0};
        const Vector3 gripped_N = find_given_N(grip);
        CHECK(gripped_N.norm() == Approx(3.0).epsilon(1.0e-6));
        CHECK(gripped_N.normalized().dot(-pull_N.normalized()) > 0.9);
        const Vector3 pushed_N = find_given_N(
            make_touch(*make_held(), {0.0, 2.9, 0.0}, slopes, Vector3::UnitY(), 3.0, 2.0));
        CHECK(pushed_N.norm() <= 3.0 * (1.0 + 1.0e-6));
        CHECK(std::hypot(pushed_N.x(), pushed_N.z()) <= 2.0 * (1.0 + 1.0e-6));
        CHECK(pushed_N.y() >= -1.0e-6);
    }
    const auto push_along = [](double length) {
        const auto world = make_held(kDown);
        BodyHold hold =
            make_touch(*world, {1.0, 3.0, 0.5}, kHand, length * Vector3(0.6, 0.8, 0.0), 9.0, 0.5);
        hold.at_W = {0.01, 0.0, 0.0};
        world->hold(0, hold);
        world->step(0.01);
        return world->state(0).velocity_W.linear;
    };
    CHECK(push_along(1.0).norm() > 0.01);
    for (const double length : {1.0e-3, 7.0}) {
        CHECK((push_along(length) - push_along(1.0)).norm() < 1.0e-12);
    }
}

TEST_CASE("rigid world: a hold that is no number or of no body is passed over") {
    const Wrench push{{1.0, 0.0, 0.0}, Vector3::Zero()};
    const auto world = make_held();
    const auto moves = [&](const BodyHold& hold) {
        world->place(0, Pose{}, {});
        world->hold(0, hold);
        world->step(0.001);
        return world->state(0).velocity_W.linear.norm() > 0.0;
    };
    using H = BodyHold;
    const BodyHold good = make_hold(Vector3::Zero(), push, {400.0, 6.0, 0.3, 0.01, 0.05});
    check_refused(
        good, moves,
        {[](H& hold) { hold.at_W.setConstant(kNan); }, [](H& hold) { hold.at_W.x() = 1.0e160; },
         [](H& hold) { hold.push_W.force.setConstant(kNan); },
         [](H& hold) { hold.push_W.torque.setConstant(kNan); },
         [](H& hold) { hold.slopes.stiffness_N_per_m = -1.0; },
         [](H& hold) { hold.slopes.damping_Ns_per_m = kNan; },
         [](H& hold) { hold.bounds.along_W.setConstant(kNan); },
         [](H& hold) { hold.bounds.most_N = HUGE_VAL; },
         [](H& hold) { hold.bounds.friction_N = -1.0; }});
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
    const auto world = make_held();
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
    plan.bodies = {plan_ground(), plan_cube(0.05, {0.0, 0.05, 0.0}),
                   plan_cube(0.05, {0.0, 0.15, 0.0})};
    auto world = make_rigid_world(plan);
    run(*world, 1.5);
    REQUIRE(world->is_asleep(2));
    world->set_present(1, false);
    run(*world, 1.0);
    CHECK(world->state(1).pose_W.position.y() == Approx(0.05).margin(1.0e-4));
    CHECK(world->state(2).pose_W.position.y() == Approx(0.05).margin(1.0e-4));
    // Where it comes back the other one is: they part again.
    world->place(1, Pose::at({0.5, 0.05, 0.0}), {});
    world->set_present(1, true);
    world->push(1, {{0.0, 20.0, 0.0}, Vector3::Zero()});
    world->step(0.001);
    CHECK(world->state(1).velocity_W.linear.y() > 0.0);
}

TEST_CASE("rigid world: what is pushed while it is away, or before it is placed, stays at rest") {
    const auto world = make_held();
    const Wrench push{{9.0, 0.0, 0.0}, {0.0, 0.1, 0.0}};
    const auto load = [&] {
        world->push(0, push);
        BodyHold hold = make_hold({0.0, 0.05, 0.0}, push, {400.0, 6.0, 0.3, 0.01, 0.05});
        hold.bounds = {.most_N = 10.0, .most_Nm = 1.0};
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
          Approx(9.0 * 0.001 / kHeldMass_kg).epsilon(1.0e-12));
}

}  // namespace
}  // namespace fulcrum
