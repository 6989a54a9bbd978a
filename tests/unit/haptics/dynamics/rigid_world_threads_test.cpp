#include "haptics/dynamics/rigid_world.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <cstring>
#include <vector>

namespace fulcrum {
namespace {

// Piles of three, four and five boxes, chains between some, in islands that meet and part again.
RigidWorldPlan make_busy_plan(int n_threads) {
    RigidWorldPlan plan;
    plan.settings.n_threads = n_threads;
    plan.settings.slow_period_s = 0.004;
    plan.bodies.push_back({.role = BodyRole::ground});
    for (int pile = 0; pile < 9; ++pile) {
        const double x = 0.4 * pile;
        for (int i = 0; i < 3 + pile % 3; ++i) {
            plan.bodies.push_back(
                {.shape = BoxShape{{0.05, 0.03, 0.04}},
                 .mass_kg = 0.1 + 0.05 * i,
                 .pose_W = Pose::at({x + 0.004 * i, 0.03 + 0.065 * i, 0.002 * pile * i})});
        }
        plan.bodies.push_back({.shape = SphereShape{0.03},
                               .mass_kg = 0.2,
                               .pose_W = Pose::at({x, 0.7, 0.0}),
                               .velocity_W = {{0.6 - 0.1 * pile, 0.0, 0.0}, Vector3::Zero()}});
        const auto ball = static_cast<std::int32_t>(plan.bodies.size()) - 1;
        if (pile % 2 == 0) {
            plan.joints.push_back(
                {.kind = JointKind::ball, .body_b = ball, .anchor_W = {x, 0.95, 0.0}});
        }
    }
    return plan;
}

std::vector<unsigned char> run_busy_world(int n_threads) {
    auto world = std::move(RigidWorld::create(make_busy_plan(n_threads)).value());
    std::vector<unsigned char> bytes;
    const auto keep = [&](const auto& value) {
        unsigned char copy[sizeof(value)];
        std::memcpy(copy, &value, sizeof(value));
        bytes.insert(bytes.end(), copy, copy + sizeof(value));
    };
    int n_solved = 0;
    for (int i = 0; i < 700; ++i) {
        BodyHold hold{.at_W = world->shape_pose_W(2).position,
                      .push_W = {Vector3(0.3, 0.0, 0.1), Vector3::Zero()}};
        hold.slopes = {500.0, 5.0, 0.0, 0.0, 0.02};
        hold.bounds.most_N = 5.0;
        world->hold(2 + i / 100, hold);
        world->step(1.0e-3);
        n_solved += world->report().n_solved;
        if (i % 50 != 0) {
            continue;
        }
        for (std::int32_t body = 0; body < world->n_bodies(); ++body) {
            const RigidState& state = world->state(body);
            keep(state.pose_W.position);
            keep(state.pose_W.orientation.coeffs());
            keep(state.velocity_W.linear);
            keep(state.velocity_W.angular);
        }
        keep(world->report().residual_m_per_s);
        keep(world->report().deepest_m);
        keep(world->report().n_contacts);
    }
    keep(n_solved);
    return bytes;
}

TEST_CASE("rigid world: it is the same to the bit on one, two and three threads") {
    const std::vector<unsigned char> alone = run_busy_world(1);
    CHECK(run_busy_world(2) == alone);
    CHECK(run_busy_world(3) == alone);
}

TEST_CASE("rigid world: a number of threads out of range is refused") {
    for (const int n_threads : {0, 17}) {
        const auto world = RigidWorld::create(make_busy_plan(n_threads));
        REQUIRE_FALSE(world);
        CHECK(world.error().message.find("threads") != std::string::npos);
    }
}

}  // namespace
}  // namespace fulcrum
