// What a world of rigid bodies reserves, against what it is said to.
#include "haptics/dynamics/rigid_world.h"
#include "tests/support/sanitized.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <malloc.h>
#include <vector>

namespace fulcrum {
namespace {

// All that the heap holds, small blocks and large ones.
double find_used_bytes() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

struct World {
    int n_bodies;
    int n_joints;
    int most_pairs;  // 0: as many as a world of that size gets
    int n_threads;
    ContactMethod method = ContactMethod::newton;
};

RigidWorldPlan make_plan(const World& world) {
    RigidWorldPlan plan;
    plan.settings.most_pairs = world.most_pairs;
    plan.settings.n_threads = world.n_threads;
    plan.settings.solver.method = world.method;
    for (int i = 0; i < world.n_bodies; ++i) {
        plan.bodies.push_back(
            {.shape = BoxShape{Vector3::Constant(0.05)}, .pose_W = Pose::at({0.3 * i, 0.0, 0.0})});
    }
    for (int i = 0; i < world.n_joints; ++i) {
        const int body = i % (world.n_bodies - 1);
        plan.joints.push_back({.kind = JointKind::ball,
                               .body_a = body,
                               .body_b = body + 1,
                               .anchor_W = {0.3 * body + 0.15, 0.0, 0.0}});
    }
    return plan;
}

TEST_CASE("rigid world build: what a world reserves is what was estimated, to a factor of two") {
    if (is_sanitized()) {
        SUCCEED("a sanitizer brings a heap of its own");
        return;
    }
    using enum ContactMethod;
    for (const World& world :
         {World{2, 0, 0, 1}, World{10, 0, 0, 1}, World{10, 0, 450, 1}, World{100, 0, 0, 1},
          World{100, 0, 0, 4}, World{400, 0, 0, 1}, World{1500, 0, 100, 1}, World{100, 99, 16, 1},
          World{100, 990, 16, 2}, World{20, 0, 64, 1, dantzig}, World{20, 10, 150, 2, dantzig},
          World{100, 0, 0, 2, iterative}}) {
        CAPTURE(world.n_bodies, world.n_joints, world.most_pairs, world.n_threads);
        const RigidWorldPlan plan = make_plan(world);
        const double before = find_used_bytes();
        const auto made = RigidWorld::create(plan);
        const double reserved = find_used_bytes() - before;
        REQUIRE(made);
        const double estimated = estimate_bytes(plan);
        CHECK(reserved <= estimated);
        CHECK(estimated <= 2.0 * reserved);
    }
}

RigidWorldPlan make_stack_and_ball() {
    RigidWorldPlan plan;
    plan.bodies.push_back({.role = BodyRole::ground});
    for (int i = 0; i < 10; ++i) {
        plan.bodies.push_back({.shape = BoxShape{Vector3::Constant(0.05)},
                               .mass_kg = 1.0,
                               .pose_W = Pose::at({0.0, 0.05 + 0.1 * i, 0.0})});
    }
    plan.bodies.push_back({.shape = SphereShape{0.02},
                           .mass_kg = 0.1,
                           .pose_W = Pose::at({1.0, 0.03, 0.0}),
                           .velocity_W = {{0.0, -20.0, 0.0}, Vector3::Zero()},
                           .restitution = 0.5});
    return plan;
}

TEST_CASE("rigid world build: what is prepared does not move, and its first step is as the next") {
    for (const double slow_s : {0.0, 0.01}) {
        CAPTURE(slow_s);
        RigidWorldPlan plan = make_stack_and_ball();
        plan.settings.slow_period_s = slow_s;
        const auto prepared = RigidWorld::create(plan).value();
        const auto plain = RigidWorld::create(plan).value();
        constexpr double kStep_s = 1.0e-3;
        prepared->prepare(kStep_s);
        int n_prepared = 0;
        int n_plain = 0;
        for (std::int32_t i = 0; i < prepared->n_bodies(); ++i) {
            CHECK(prepared->state(i).pose_W.position == plain->state(i).pose_W.position);
            CHECK(prepared->state(i).velocity_W.linear == plain->state(i).velocity_W.linear);
            CHECK(prepared->state(i).velocity_W.angular == plain->state(i).velocity_W.angular);
            CHECK(prepared->behind_s(i) == 0.0);
        }
        for (int i = 0; i < 100; ++i) {
            prepared->step(kStep_s);
            plain->step(kStep_s);
            n_prepared += i < 10 ? prepared->report().n_iterations : 0;
            n_plain += i < 10 ? plain->report().n_iterations : 0;
        }
        // What of the ball is to be solved both have.
        CHECK(n_prepared < n_plain);
        for (std::int32_t i = 0; i < prepared->n_bodies(); ++i) {
            const Vector3 apart =
                prepared->state(i).pose_W.position - plain->state(i).pose_W.position;
            CHECK(apart.norm() < 1.0e-7);
        }
    }
}

TEST_CASE("rigid world build: a world is prepared before its first step alone, and for a time") {
    RigidWorldPlan plan = make_stack_and_ball();
    const auto world = RigidWorld::create(plan).value();
    const auto plain = RigidWorld::create(plan).value();
    world->prepare(std::nan(""));
    world->prepare(-1.0);
    for (int i = 0; i < 20; ++i) {
        world->step(1.0e-3);
        world->prepare(1.0e-3);
        plain->step(1.0e-3);
        CHECK(world->report().n_iterations == plain->report().n_iterations);
    }
    for (std::int32_t i = 0; i < world->n_bodies(); ++i) {
        CHECK(world->state(i).pose_W.position == plain->state(i).pose_W.position);
    }
}

TEST_CASE("rigid world build: a world for which there is no room is refused with its size") {
    RigidWorldPlan plan = make_plan({20, 0, 0, 1, ContactMethod::dantzig});
    plan.settings.most_pairs = 4000;
    CHECK(estimate_bytes(plan) > 4.0e9);
    const auto refused = RigidWorld::create(plan);
    REQUIRE_FALSE(refused);
    CHECK(to_sentence(refused.error()).find("20 bodies and 4000 pairs") != std::string::npos);
    // The same pairs without the matrix of all rows have room.
    plan.settings.solver.method = ContactMethod::newton;
    CHECK(validate(plan));
}

}  // namespace
}  // namespace fulcrum
