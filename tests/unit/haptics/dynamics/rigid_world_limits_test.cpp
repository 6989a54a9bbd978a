// Who sleeps, how large a world may be, what it reserves and prepares, on how many threads, and what wakes or is refused.
#include "haptics/dynamics/rigid_world.h"
#include "tests/support/refused.h"
#include "tests/support/rigid_worlds.h"
#include "tests/support/sanitized.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <malloc.h>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kStep_s = 1.0e-3;

TEST_CASE("rigid world: what is pushed apart does not sleep before it is") {
    RigidWorldPlan plan = plan_weightless(
        {plan_cube(0.5, Vector3::Zero(), 1.0), plan_cube(0.5, {0.98, 0.0, 0.0}, 1.0)});
    plan.settings.sleep_after_s = 0.02;
    plan.settings.push_rate_per_s = 2.0;
    auto world = make_rigid_world(plan);
    run(*world, 0.2);
    CHECK_FALSE(world->is_asleep(0));
    run(*world, 3.0);
    CHECK(world->is_asleep(0));
    const double apart_m =
        world->shape_pose_W(1).position.x() - world->shape_pose_W(0).position.x();
    CHECK(apart_m >= 1.0 - 2.0e-3);
}

TEST_CASE("rigid world: what floats on slowly and touches nothing floats on") {
    RigidWorldPlan plan;
    plan.settings.gravity_W.setZero();
    plan.bodies = {plan_ball(0.05, Vector3::Zero(), 0.0, {1.5e-3, 0.0, 0.0})};
    auto world = make_rigid_world(plan);
    run(*world, 2.0);
    CHECK(world->state(0).pose_W.position.x() == Approx(3.0e-3));
    CHECK_FALSE(world->is_asleep(0));
}

TEST_CASE("rigid world: two thousand balls lie on level ground, and none is dropped") {
    RigidWorldPlan plan;
    plan.bodies = {plan_ground()};
    for (int i = 0; i < 2000; ++i) {
        plan.bodies.push_back(plan_ball(0.05, {0.2 * (i % 50), 0.05, 0.2 * (i / 50)}, 1.0));
    }
    auto world = make_rigid_world(plan);
    run(*world, 0.005);
    CHECK(world->report().n_dropped == 0);
    CHECK(world->report().n_contacts == 2000);
    // What is high above it is no pair.
    plan.bodies.resize(3);
    plan.bodies[2].pose_W = Pose::at({1.0, 1.0, 0.0});
    auto high = make_rigid_world(plan);
    high->step(kStep_s);
    CHECK(high->contacts().count() == 1);
}

// Each of two that fly reaches all others within the step; there is room for one pair.
TEST_CASE("rigid world: without room for all pairs what lies on the ground keeps its own") {
    RigidWorldPlan plan;
    plan.settings.most_pairs = 1;
    const Vector3 fast(0.0, 0.0, 400.0);
    plan.bodies = {plan_ball(0.05, {-0.3, 0.6, 0.0}, 0.0, fast),
                   plan_ball(0.05, {0.3, 0.6, 0.0}, 0.0, fast), plan_ball(0.05, {0.0, 0.05, 0.0}),
                   plan_ground()};
    auto world = make_rigid_world(plan);
    for (int i = 0; i < 200; ++i) {
        for (const std::int32_t flying : {0, 1}) {
            const auto body = static_cast<std::size_t>(flying);
            world->place(flying, plan.bodies[body].pose_W, plan.bodies[body].velocity_W);
        }
        world->step(kStep_s);
        REQUIRE(world->report().n_dropped > 0);
    }
    CHECK(world->shape_pose_W(2).position.y() == Approx(0.05).margin(1.0e-4));
}

// A cube of 1 kg on four points, of which the second is nowhere: half its weight is on the first, a quarter on each of the last two.
TEST_CASE("rigid world: of a refused contact nothing is remembered, and others keep theirs") {
    RigidScene scene{{RigidWorldBody{}, RigidWorldBody{}}, ContactPairs(1), {}, BodyLoads(0)};
    RigidWorldBody& cube = scene.bodies[0];
    cube.shape = make_contact_shape(BoxShape{Vector3::Constant(0.05)}).value();
    cube.inertia = make_box_inertia(1.0, Vector3::Constant(0.1));
    cube.inertia_W = cube.inertia.moments_kg_m2.asDiagonal();
    cube.moves = true;
    cube.state.pose_W.position.y() = 0.05;
    scene.bodies[1].shape = make_half_space();
    const std::array<BodyPair, 1> touching{BodyPair{0, 1}};
    scene.pairs.update(touching);
    ContactPair& pair = scene.pairs.at(0);
    pair.remember({12, Vector3::UnitY(), false});
    const std::array<Vector3, 4> places{Vector3(-0.05, 0.0, 0.0), Vector3::Constant(std::nan("")),
                                        Vector3(0.05, 0.0, -0.05), Vector3(0.05, 0.0, 0.05)};
    for (const Vector3& place : places) {
        const auto i = static_cast<std::size_t>(pair.manifold.count++);
        pair.manifold.contacts[i].place_W = place;
        pair.manifold.contacts[i].id = static_cast<std::uint32_t>(11 + i);
    }
    IslandSolver solver({}, {.bodies = 1, .contacts = 4, .rows = 0});
    const std::array<std::int32_t, 1> first{0};
    const IslandReport report = solver.solve({first, first, {}}, kStep_s, scene);
    CHECK(report.n_dropped == 1);
    CHECK(report.n_contacts == 3);
    CHECK(pair.n_memories == 3);
    CHECK(pair.recall(12) == nullptr);
    const double weight_Ns = 9.81 * kStep_s;
    const auto bears = [&](std::uint32_t id, double share) {
        const ContactMemory* memory = pair.recall(id);
        return memory != nullptr &&
               std::abs(memory->impulse_W.y() - share * weight_Ns) < 1.0e-6 * weight_Ns;
    };
    CHECK(bears(11, 0.5));
    CHECK(bears(13, 0.25));
    CHECK(bears(14, 0.25));
}

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
        plan.bodies.push_back(plan_cube(0.05, {0.3 * i, 0.0, 0.0}));
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
    plan.bodies.push_back(plan_ground());
    for (int i = 0; i < 10; ++i) {
        plan.bodies.push_back(plan_cube(0.05, {0.0, 0.05 + 0.1 * i, 0.0}, 1.0));
    }
    plan.bodies.push_back(
        with_restitution(plan_ball(0.02, {1.0, 0.03, 0.0}, 0.1, {0.0, -20.0, 0.0}), 0.5));
    return plan;
}

TEST_CASE("rigid world build: what is prepared does not move, and its first step is as the next") {
    for (const double slow_s : {0.0, 0.01}) {
        CAPTURE(slow_s);
        RigidWorldPlan plan = make_stack_and_ball();
        plan.settings.slow_period_s = slow_s;
        const auto prepared = make_rigid_world(plan);
        const auto plain = make_rigid_world(plan);
        prepared->prepare(kStep_s);
        for (std::int32_t i = 0; i < prepared->n_bodies(); ++i) {
            CHECK(prepared->state(i).pose_W.position == plain->state(i).pose_W.position);
            CHECK(prepared->state(i).velocity_W.linear == plain->state(i).velocity_W.linear);
            CHECK(prepared->state(i).velocity_W.angular == plain->state(i).velocity_W.angular);
            CHECK(prepared->behind_s(i) == 0.0);
        }
        int n_spared = 0;
        for (int i = 0; i < 100; ++i) {
            prepared->step(kStep_s);
            plain->step(kStep_s);
            n_spared += i < 10 ? plain->report().n_iterations - prepared->report().n_iterations : 0;
        }
        // What of the ball is to be solved both have.
        CHECK(n_spared > 0);
        for (std::int32_t i = 0; i < prepared->n_bodies(); ++i) {
            CHECK((prepared->state(i).pose_W.position - plain->state(i).pose_W.position).norm() <
                  1.0e-7);
        }
    }
}

TEST_CASE("rigid world build: a world is prepared before its first step alone, and for a time") {
    const auto world = make_rigid_world(make_stack_and_ball());
    const auto plain = make_rigid_world(make_stack_and_ball());
    world->prepare(std::nan(""));
    world->prepare(-1.0);
    for (int i = 0; i < 20; ++i) {
        world->step(kStep_s);
        world->prepare(kStep_s);
        plain->step(kStep_s);
        CHECK(world->report().n_iterations == plain->report().n_iterations);
    }
    for (std::int32_t i = 0; i < world->n_bodies(); ++i) {
        CHECK(world->state(i).pose_W.position == plain->state(i).pose_W.position);
    }
}

TEST_CASE("rigid world build: a world for which there is no room is refused with its size") {
    struct Size {
        int n_bodies, most_pairs;
        ContactMethod method;
        const char* told;  // none: there is room
    };
    using enum ContactMethod;
    for (const Size& size :
         {Size{1, 0, newton, nullptr}, Size{1, 1000000, newton, "1000000 pairs needs some 11 GB"},
          Size{1, 10000, newton, nullptr}, Size{1, 10000, dantzig, ""},
          Size{1, 0, dantzig, nullptr}, Size{1, -1, dantzig, ""},
          Size{20, 4000, dantzig, "20 bodies and 4000 pairs"},
          // The same pairs without the matrix of all rows have room.
          Size{20, 4000, newton, nullptr}}) {
        CAPTURE(size.n_bodies, size.most_pairs, static_cast<int>(size.method));
        const auto checked =
            validate(make_plan({size.n_bodies, 0, size.most_pairs, 1, size.method}));
        CHECK(checked.has_value() == (size.told == nullptr));
        if (!checked && size.told != nullptr) {
            CHECK(to_sentence(checked.error()).find(size.told) != std::string::npos);
        }
    }
    const RigidWorldPlan large = make_plan({20, 0, 4000, 1, dantzig});
    CHECK(estimate_bytes(large) > 4.0e9);
    CHECK_FALSE(RigidWorld::create(large));
}

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
    auto world = make_rigid_world(make_busy_plan(n_threads));
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

TEST_CASE("rigid world: the same to the bit on one to three threads; 0 and 17 are refused") {
    const std::vector<unsigned char> alone = run_busy_world(1);
    CHECK(run_busy_world(2) == alone);
    CHECK(run_busy_world(3) == alone);
    for (const int n_threads : {0, 17}) {
        CHECK(is_refused(RigidWorld::create(make_busy_plan(n_threads)), "threads"));
    }
}

}  // namespace
}  // namespace fulcrum
