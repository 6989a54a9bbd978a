#include "haptics/dynamics/rigid_world.h"
#include "tests/support/rigid_worlds.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace fulcrum {
namespace {

constexpr double kAheadStep_s = 1.0e-3;

RigidBodyPlan make_ball(double radius_m, const Vector3& at, const Vector3& velocity,
                        double restitution) {
    return with_restitution(plan_ball(radius_m, at, 1.0, velocity), restitution);
}

RigidBodyPlan make_wall(double half_m, double x_m) {
    return plan_wall(BoxShape{{half_m, 1.0, 1.0}}, {x_m, 0.0, 0.0});
}

std::unique_ptr<RigidWorld> begin(std::vector<RigidBodyPlan> bodies, double slow_period_s = 0.0) {
    RigidWorldPlan plan = plan_weightless(std::move(bodies));
    plan.settings.most_pairs = 16;
    plan.settings.slow_period_s = slow_period_s;
    return make_rigid_world(plan);
}

TEST_CASE("rigid world ahead: what passes by feels nothing, however fast and near") {
    struct Pass {
        double speed_m_per_s, slow_s, clear_m;
    };
    for (const Pass& pass : {Pass{100.0, 0.0, 0.01}, Pass{10.0, 0.0, 1.0e-3},
                             Pass{1.0, 0.02, 3.0e-3}, Pass{2.0, 0.02, 0.01}}) {
        for (const double restitution : {0.0, 1.0}) {
            CAPTURE(pass.speed_m_per_s, restitution);
            const Vector3 velocity(pass.speed_m_per_s, 0.0, 0.0);
            const auto world =
                begin({make_ball(0.01, {-0.3, 0.06 + pass.clear_m, 0.0}, velocity, restitution),
                       plan_cube(0.05, Vector3::Zero(), 1.0)},
                      pass.slow_s);
            const int n_steps = static_cast<int>(0.6 / pass.speed_m_per_s / kAheadStep_s);
            for (int i = 0; i < n_steps; ++i) {
                world->step(kAheadStep_s);
            }
            CHECK(world->state(0).velocity_W.linear == velocity);
            CHECK(world->state(1).velocity_W.linear.isZero(0.0));
        }
    }
}

TEST_CASE("rigid world ahead: a ball bounces off what it hits, not off the wall behind it") {
    for (const double behind_m : {0.02, 0.062, 0.095}) {
        CAPTURE(behind_m);
        const double wall_m = 0.0205 + behind_m;
        const auto world = begin({make_ball(0.02, {-0.0437, 0.0, 0.0}, {100.0, 0.0, 0.0}, 1.0),
                                  make_ball(0.02, Vector3::Zero(), Vector3::Zero(), 1.0),
                                  make_wall(0.0005, wall_m)});
        double farthest_m = 0.0;
        double fastest = 0.0;
        int n_held = 0;
        for (int i = 0; i < 20; ++i) {
            world->step(kAheadStep_s);
            farthest_m = std::max(farthest_m, world->state(1).pose_W.position.x());
            fastest = std::max(fastest, world->state(1).velocity_W.linear.x());
            n_held += world->report().n_held;
        }
        // The struck ball flies on at the other's speed and meets the wall, which nobody had looked for: it is not behind it.
        CHECK(fastest == Approx(100.0));
        CHECK(farthest_m <= wall_m - 0.0005 - 0.02 + 1.0e-6);
        CHECK(n_held > 0);
        // It comes back from it, and the other leaves as it came.
        CHECK(world->state(0).velocity_W.linear.x() == Approx(-100.0));
        CHECK(world->state(1).velocity_W.linear.norm() < 1.0e-6);
    }
}

TEST_CASE(
    "rigid world ahead: pushed to a thin wall it stays before it; skidding, it rolls off alike") {
    for (const double mass_kg : {0.01, 0.001}) {
        CAPTURE(mass_kg);
        const auto world =
            begin({plan_cube(0.005, Vector3::Zero(), mass_kg), make_wall(0.0003, 0.0058)});
        for (int i = 0; i < 100; ++i) {
            world->push(0, {{10.0, 0.0, 0.0}, {0.0, 0.0, 0.0}});
            world->step(kAheadStep_s);
        }
        CHECK(world->state(0).pose_W.position.x() == Approx(0.0005).margin(1.0e-6));
    }
    // It sticks to the ground: v = v_0 5/7, and w = v / r.
    for (const double phase_m : {1.0e-4, 3.0e-3, 6.0e-3, 9.9e-3}) {
        CAPTURE(phase_m);
        const auto world = begin(
            {plan_ground(), make_ball(0.01, {0.0, 0.01 + phase_m, 0.0}, {5.0, -10.0, 0.0}, 0.0)});
        run(*world, 0.01);
        CHECK(world->state(1).velocity_W.linear.x() == Approx(5.0 * 5.0 / 7.0).epsilon(1.0e-3));
        CHECK(world->state(1).velocity_W.angular.z() == Approx(-500.0 * 5.0 / 7.0).epsilon(1.0e-3));
    }
}

TEST_CASE("rigid world ahead: a ball bounces where it touches, in whatever phase of the step") {
    constexpr double kRadius_m = 0.02;
    // 2e-3 of the smaller one's size.
    constexpr double kTolerance_m = 2.0e-3 * kRadius_m;
    for (const double restitution : {1.0, 0.5}) {
        for (const double speed : {2.0, 17.0, 100.0}) {
            for (const double phase : {0.03, 0.31, 0.77, 0.99}) {
                CAPTURE(restitution, speed, phase);
                const double way_m = (2.0 + phase) * speed * kAheadStep_s;
                const auto world =
                    begin({make_ball(kRadius_m, Vector3::Zero(), {speed, 0.0, 0.0}, restitution),
                           make_wall(0.0005, 0.0005 + kRadius_m + way_m)});
                double before_m_per_s = speed;
                for (int i = 1; i <= 6; ++i) {
                    world->step(kAheadStep_s);
                    const double on_m = i * speed * kAheadStep_s;
                    const double at_m = on_m < way_m ? on_m : way_m - restitution * (on_m - way_m);
                    CHECK(world->state(0).pose_W.position.x() ==
                          Approx(at_m).margin(1.05 * kTolerance_m));
                    // It goes back only once it has been there.
                    const double now_m_per_s = world->state(0).velocity_W.linear.x();
                    CHECK((i == 3 || (now_m_per_s < 0.0) == (before_m_per_s < 0.0)));
                    before_m_per_s = now_m_per_s;
                }
                CHECK(before_m_per_s == Approx(-restitution * speed));
            }
        }
    }
}

TEST_CASE(
    "rigid world ahead: balls that meet in a step, or in a narrow gap, are where they would be") {
    for (const double phase : {0.1, 0.5, 0.9}) {
        CAPTURE(phase);
        const auto world =
            begin({make_ball(0.01, {-phase * 0.05 - 0.02, 0.0, 0.0}, {50.0, 0.0, 0.0}, 1.0),
                   make_ball(0.01, Vector3::Zero(), Vector3::Zero(), 1.0)});
        world->step(kAheadStep_s);
        // The one stands where they touched, the other goes on by what was left of the step.
        CHECK(world->state(0).pose_W.position.x() == Approx(-0.02).margin(4.0e-5));
        CHECK(world->state(1).pose_W.position.x() == Approx((1.0 - phase) * 0.05).margin(4.0e-5));
        CHECK(world->state(1).velocity_W.linear.x() == Approx(50.0));
    }
    // 4 mm to go at 20 m/s: five bounces a step, more than are followed.
    const auto world = begin({make_ball(0.01, Vector3::Zero(), {20.0, 0.0, 0.0}, 1.0),
                              make_wall(0.01, 0.022), make_wall(0.01, -0.022)});
    for (int i = 0; i < 100; ++i) {
        world->step(kAheadStep_s);
        REQUIRE(std::abs(world->state(0).pose_W.position.x()) <= 0.002 + 2.0e-5);
        REQUIRE(std::abs(world->state(0).velocity_W.linear.x()) == Approx(20.0));
    }
}

TEST_CASE("rigid world ahead: what flies off with nothing before it is not held") {
    const auto world = begin({make_ball(0.02, {-0.05, 0.0, 0.0}, {100.0, 0.0, 0.0}, 1.0),
                              make_ball(0.02, Vector3::Zero(), Vector3::Zero(), 1.0)});
    const double energy_J = world->compute_energy_J();
    int n_held = 0;
    for (int i = 0; i < 10; ++i) {
        world->step(kAheadStep_s);
        n_held += world->report().n_held;
    }
    CHECK(n_held == 0);
    CHECK(world->compute_energy_J() == Approx(energy_J));
    CHECK(world->state(1).pose_W.position.x() > 0.85);
}

}  // namespace
}  // namespace fulcrum
