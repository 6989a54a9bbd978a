// Joints' limits, who sleeps, and how large a world may be.
#include "haptics/dynamics/rigid_world.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kLimitStep_s = 1.0e-3;

std::unique_ptr<RigidWorld> make_limited(const RigidWorldPlan& plan) {
    auto world = RigidWorld::create(plan);
    REQUIRE(world);
    return std::move(*world);
}

void run_for(RigidWorld& world, double time_s) {
    for (int i = 0; i < static_cast<int>(std::lround(time_s / kLimitStep_s)); ++i) {
        world.step(kLimitStep_s);
    }
}

RigidWorldPlan make_weightless() {
    RigidWorldPlan plan;
    plan.settings.gravity_W.setZero();
    return plan;
}

// A ball of 1 kg joined to the world about or along z.
RigidWorldPlan make_joined(JointKind kind, const JointDrive& drive, const Twist& velocity_W = {}) {
    RigidWorldPlan plan = make_weightless();
    plan.bodies = {{.shape = SphereShape{0.05}, .mass_kg = 1.0, .velocity_W = velocity_W}};
    plan.joints = {{.kind = kind, .body_b = 0, .axis_W = Vector3::UnitZ(), .drive = drive}};
    return plan;
}

TEST_CASE("rigid world: a motor turns a hinge to its limit, beyond half a turn and beyond two") {
    for (const double limit_rad : {4.0, 15.0}) {
        CAPTURE(limit_rad);
        auto up = make_limited(make_joined(
            JointKind::hinge, {.upper = limit_rad, .motor_speed = 8.0, .motor_force = 1.0}));
        auto down = make_limited(make_joined(
            JointKind::hinge, {.lower = -limit_rad, .motor_speed = -8.0, .motor_force = 1.0}));
        run_for(*up, 3.0);
        run_for(*down, 3.0);
        CHECK(up->joint_travel(0) == Approx(limit_rad).epsilon(1.0e-6));
        CHECK(down->joint_travel(0) == Approx(-limit_rad).epsilon(1.0e-6));
        CHECK(up->state(0).velocity_W.angular.norm() <= 1.0e-6);
    }
}

TEST_CASE("rigid world: a limit on one side leaves the other side free") {
    auto world = make_limited(
        make_joined(JointKind::hinge, {.upper = 1.0}, {Vector3::Zero(), {0.0, 0.0, -4.0}}));
    run_for(*world, 1.5);
    CHECK(world->joint_travel(0) == Approx(-6.0).epsilon(1.0e-3));
    CHECK(world->state(0).velocity_W.angular.z() == Approx(-4.0).epsilon(1.0e-6));
}

TEST_CASE("rigid world: a slider passes neither limit, though a step would pass both") {
    for (const double speed_m_per_s : {10.0, -10.0}) {
        CAPTURE(speed_m_per_s);
        auto world =
            make_limited(make_joined(JointKind::slider, {.lower = -1.0e-3, .upper = 2.0e-3},
                                     {{0.0, 0.0, speed_m_per_s}, Vector3::Zero()}));
        for (int i = 0; i < 20; ++i) {
            world->step(kLimitStep_s);
            CHECK(world->joint_travel(0) <= 2.0e-3 + 1.0e-7);
            CHECK(world->joint_travel(0) >= -1.0e-3 - 1.0e-7);
        }
    }
}

TEST_CASE("rigid world: what is pushed apart does not sleep before it is") {
    RigidWorldPlan plan = make_weightless();
    plan.settings.sleep_after_s = 0.02;
    plan.settings.push_rate_per_s = 2.0;
    const RigidBodyPlan cube{.shape = BoxShape{Vector3::Constant(0.5)}, .mass_kg = 1.0};
    plan.bodies = {cube, cube};
    plan.bodies[1].pose_W = Pose::at({0.98, 0.0, 0.0});
    auto world = make_limited(plan);
    run_for(*world, 0.2);
    CHECK_FALSE(world->is_asleep(0));
    run_for(*world, 3.0);
    CHECK(world->is_asleep(0));
    const double apart_m =
        world->shape_pose_W(1).position.x() - world->shape_pose_W(0).position.x();
    CHECK(apart_m >= 1.0 - 2.0e-3);
}

TEST_CASE("rigid world: a slow motor is not put to sleep, and a motor at rest is") {
    JointDrive drive{.motor_speed = 0.02, .motor_force = 1.0};
    auto turning = make_limited(make_joined(JointKind::hinge, drive));
    run_for(*turning, 2.0);
    CHECK(turning->joint_travel(0) == Approx(0.04).epsilon(1.0e-3));
    drive.motor_speed = 0.0;
    auto held = make_limited(make_joined(JointKind::hinge, drive));
    run_for(*held, 1.0);
    CHECK(held->is_asleep(0));
}

TEST_CASE("rigid world: what floats on slowly and touches nothing floats on") {
    RigidWorldPlan plan = make_weightless();
    plan.bodies = {
        {.shape = SphereShape{0.05}, .velocity_W = {{1.5e-3, 0.0, 0.0}, Vector3::Zero()}}};
    auto world = make_limited(plan);
    run_for(*world, 2.0);
    CHECK(world->state(0).pose_W.position.x() == Approx(3.0e-3));
    CHECK_FALSE(world->is_asleep(0));
}

TEST_CASE("rigid world: two thousand balls lie on level ground, and none is dropped") {
    RigidWorldPlan plan;
    plan.bodies = {{.role = BodyRole::ground}};
    for (int i = 0; i < 2000; ++i) {
        plan.bodies.push_back({.shape = SphereShape{0.05},
                               .mass_kg = 1.0,
                               .pose_W = Pose::at({0.2 * (i % 50), 0.05, 0.2 * (i / 50)})});
    }
    auto world = make_limited(plan);
    run_for(*world, 0.005);
    CHECK(world->report().n_dropped == 0);
    CHECK(world->report().n_contacts == 2000);
    // What is high above it is no pair.
    plan.bodies.resize(3);
    plan.bodies[2].pose_W = Pose::at({1.0, 1.0, 0.0});
    auto high = make_limited(plan);
    high->step(kLimitStep_s);
    CHECK(high->contacts().count() == 1);
}

// Each of two that fly reaches all others within the step; there is room for one pair.
TEST_CASE(
    "rigid world: where there is no room for all pairs what lies on the ground keeps its own") {
    RigidWorldPlan plan;
    plan.settings.most_pairs = 1;
    for (const double side : {-1.0, 1.0}) {
        plan.bodies.push_back({.shape = SphereShape{0.05},
                               .pose_W = Pose::at({0.3 * side, 0.6, 0.0}),
                               .velocity_W = {{0.0, 0.0, 400.0}, Vector3::Zero()}});
    }
    plan.bodies.push_back({.shape = SphereShape{0.05}, .pose_W = Pose::at({0.0, 0.05, 0.0})});
    plan.bodies.push_back({.role = BodyRole::ground});
    auto world = make_limited(plan);
    for (int i = 0; i < 200; ++i) {
        for (const std::int32_t flying : {0, 1}) {
            const auto body = static_cast<std::size_t>(flying);
            world->place(flying, plan.bodies[body].pose_W, plan.bodies[body].velocity_W);
        }
        world->step(kLimitStep_s);
        REQUIRE(world->report().n_dropped > 0);
    }
    CHECK(world->shape_pose_W(2).position.y() == Approx(0.05).margin(1.0e-4));
}

// A cube of 1 kg on four points, of which the second is nowhere: half its weight is on the first, a quarter on each of the last two.
TEST_CASE(
    "rigid world: of a contact that is refused nothing is remembered, and others keep theirs") {
    RigidScene scene{
        {RigidWorldBody{}, RigidWorldBody{}}, ContactPairs(1), {}, BoundedList<HeldBody>(0)};
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
    const IslandReport report = solver.solve({first, first, {}}, kLimitStep_s, scene);
    CHECK(report.n_dropped == 1);
    CHECK(report.n_contacts == 3);
    CHECK(pair.n_memories == 3);
    CHECK(pair.recall(12) == nullptr);
    const double weight_Ns = 9.81 * kLimitStep_s;
    const auto bears = [&](std::uint32_t id, double share) {
        const ContactMemory* memory = pair.recall(id);
        return memory != nullptr &&
               std::abs(memory->impulse_W.y() - share * weight_Ns) < 1.0e-6 * weight_Ns;
    };
    CHECK(bears(11, 0.5));
    CHECK(bears(13, 0.25));
    CHECK(bears(14, 0.25));
}

TEST_CASE("rigid world: a plan that would take more memory than there is likely to be is refused") {
    RigidWorldPlan plan = make_joined(JointKind::hinge, {});
    CHECK(validate(plan));
    plan.settings.most_pairs = 1000000;
    const auto many = validate(plan);
    REQUIRE_FALSE(many);
    CHECK(many.error().message.find("1000000 pairs needs some 11 GB") != std::string::npos);
    plan.settings.most_pairs = 10000;
    CHECK(validate(plan));
    plan.settings.solver.method = ContactMethod::dantzig;
    CHECK_FALSE(validate(plan));
    plan.settings.most_pairs = 0;
    CHECK(validate(plan));
    plan.settings.most_pairs = -1;
    CHECK_FALSE(validate(plan));
}

}  // namespace
}  // namespace fulcrum
