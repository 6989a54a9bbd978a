#include "haptics/dynamics/rigid_world.h"
#include "haptics/geometry/shape.h"
#include "tests/support/hollow_meshes.h"
#include "tests/support/rigid_worlds.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kStep_s = 1.0e-3;
const Vector3 kFast(0.0, -100.0, 0.0);

RigidBodyPlan make_table() {
    return plan_wall(BoxShape{{0.5, 0.05, 0.5}}, {0.0, -0.05, 0.0});
}

RigidBodyPlan make_flying(const SolidShape& shape, const Vector3& at) {
    return plan_body(shape, Pose::at(at), 0.1, {kFast, Vector3::Zero()});
}

}  // namespace

TEST_CASE("rigid world: a ball stays in a channel of triangles, a ring falls over a pole") {
    RigidBodyPlan channel =
        plan_body(touchable(make_channel(0.1, 0.02, 0.2)), Pose::at({0.0, 0.001, 0.0}));
    channel.density_kg_per_m3 = 800.0;
    const auto world =
        make_rigid_world(plan_awake({plan_ground(), channel, plan_ball(0.03, {0.01, 0.1, 0.02})}));
    run(*world, 3.0);
    const Vector3 ball = world->shape_pose_W(2).position;
    CHECK(ball.y() == Approx(0.02 + 0.03).margin(2.0e-4));
    CHECK(world->shape_pose_W(1).position.norm() < 5.0e-3);
    CHECK(world->shape_pose_W(1).position.y() == Approx(0.0).margin(1.0e-4));
    CHECK(world->report().deepest_m < 2.0e-4);
    // Nothing stops it from rolling along.
    CHECK(std::abs(ball.x()) < 0.021);
    CHECK(world->state(2).velocity_W.linear.norm() < 0.02);
    const auto with_pole = make_rigid_world(plan_awake(
        {plan_ground(), plan_wall(CylinderShape{0.03, 0.15}, {0.0, 0.15, 0.0}),
         plan_body(touchable(make_torus(0.06, 0.02, 48, 24)), Pose::at({0.005, 0.36, 0.0}))}));
    run(*with_pole, 2.0);
    const Vector3 ring = with_pole->shape_pose_W(2).position;
    CHECK(ring.y() == Approx(0.02).margin(1.0e-3));
    CHECK(std::hypot(ring.x(), ring.z()) < 0.0115);
    CHECK(with_pole->report().deepest_m < 3.0e-4);
}

TEST_CASE("rigid world: a link hangs in another, tube on tube") {
    const SolidShape link = touchable(make_torus(0.05, 0.01, 64, 24));
    const Quaternion upright(AngleAxis(0.5 * std::numbers::pi, Vector3::UnitX()));
    const Quaternion across(AngleAxis(0.5 * std::numbers::pi, Vector3::UnitZ()));
    // The upper one's lowest inside is at -0.04, the lower one's highest inside 0.04 over its middle.
    RigidWorldPlan plan = plan_awake(
        {plan_wall(link, Vector3::Zero()), plan_body(link, {{0.0, -0.0798, 0.0}, across})});
    plan.bodies[0].pose_W.orientation = upright;
    const auto world = make_rigid_world(plan);
    run(*world, 2.0);
    const Vector3 lower = world->shape_pose_W(1).position;
    CHECK(lower.y() == Approx(-0.08).margin(5.0e-4));
    CHECK(std::hypot(lower.x(), lower.z()) < 5.0e-3);
    CHECK(world->report().n_contacts > 0);
}

TEST_CASE("rigid world: a small world has room for all patches of its meshes") {
    const auto world = make_rigid_world(plan_awake(
        {plan_ground(), plan_wall(touchable(make_bowl(0.12, 0.1, 32, 8)), {0.0, 0.2, 0.0}),
         plan_ball(0.03, {-0.04, 0.2, 0.0}), plan_ball(0.03, {0.04, 0.2, 0.0})}));
    run(*world, 1.0);
    CHECK(world->report().n_dropped == 0);
    for (const int ball : {2, 3}) {
        CHECK(world->shape_pose_W(ball).position.y() > 0.12);
    }
}

TEST_CASE("rigid world: a cylinder of triangles lies still on a table") {
    const Quaternion lying(AngleAxis(0.5 * std::numbers::pi, Vector3::UnitX()));
    // On one of its twelve sides, a hair above it.
    const double high_m = 0.05 * std::cos(std::numbers::pi / 12.0) + 1.0e-4;
    const Quaternion on_side(AngleAxis(std::numbers::pi / 12.0, Vector3::UnitZ()));
    const auto world = make_rigid_world(
        plan_awake({make_table(), plan_body(touchable(make_cylinder(0.05, 0.2, 12)),
                                            {{0.0, high_m, 0.0}, on_side * lying})}));
    run(*world, 1.5);
    CHECK(world->state(1).velocity_W.linear.norm() < 1.0e-3);
    CHECK(world->shape_pose_W(1).position.y() == Approx(high_m - 1.0e-4).margin(2.0e-4));
}

TEST_CASE("rigid world: a cone of triangles stands on its tip no deeper than on the ground") {
    std::vector<Vector3> vertices{{0.0, -0.1, 0.0}, {0.0, 0.0, 0.0}};
    std::vector<TriangleCorners> triangles;
    constexpr int kSides = 32;
    for (int i = 0; i < kSides; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / kSides;
        vertices.emplace_back(0.1 * std::cos(turn), 0.0, 0.1 * std::sin(turn));
        triangles.push_back({0, 2 + i, 2 + (i + 1) % kSides});
        triangles.push_back({1, 2 + (i + 1) % kSides, 2 + i});
    }
    const auto world = make_rigid_world(
        plan_awake({make_table(), plan_body(touchable(TriangleMesh::build(vertices, triangles)),
                                            Pose::at({0.0, 0.1005, 0.0}))}));
    // It would fall over in the end; until then its tip is on the table.
    for (int i = 0; i < 200; ++i) {
        world->step(kStep_s);
        REQUIRE((world->shape_pose_W(1) * Vector3(0.0, -0.1, 0.0)).y() > -5.0e-4);
    }
}

TEST_CASE("rigid world: what is flung at a thin plate of triangles stops at it, in any phase") {
    const SolidShape plate = touchable(make_box({0.3, 0.008, 0.3}));
    const auto sampled = SampledShape::make(plate).value();
    const SolidShape ring = touchable(make_torus(0.03, 0.012, 32, 16));
    for (const bool is_ring : {false, true}) {
        const SolidShape flung = is_ring ? ring : SolidShape(SphereShape{0.012});
        for (const double phase_m : {0.0, 0.021, 0.052, 0.097}) {
            CAPTURE(is_ring, phase_m);
            RigidWorldPlan plan =
                plan_weightless({plan_wall(plate, Vector3::Zero()),
                                 make_flying(flung, {0.01, 0.2 + phase_m, 0.02})});
            plan.bodies[0].sampled = sampled;
            const auto world = make_rigid_world(plan);
            run(*world, 0.02);
            CHECK(world->shape_pose_W(1).position.y() == Approx(0.016).margin(4.0e-4));
            // A thousandth of its speed is left along the plate, for samples tell its normal so nearly.
            CHECK(world->state(1).velocity_W.linear.norm() < 0.1);
        }
    }
}

TEST_CASE("rigid world: what is flung through a ring or past it feels nothing") {
    const SolidShape ring = touchable(make_torus(0.06, 0.02, 48, 24));
    const auto sampled = SampledShape::make(ring).value();
    for (const double aside_m : {0.0, 0.015, 0.11, 0.15}) {
        for (const double phase_m : {0.0, 0.033, 0.071}) {
            CAPTURE(aside_m, phase_m);
            RigidWorldPlan plan =
                plan_weightless({plan_body(ring, Pose{}, 0.3),
                                 make_flying(SphereShape{0.02}, {aside_m, 0.25 + phase_m, 0.0})});
            plan.bodies[0].sampled = sampled;
            const auto world = make_rigid_world(plan);
            run(*world, 0.006);
            CHECK(world->state(1).velocity_W.linear == kFast);
            CHECK(world->state(0).velocity_W.linear.isZero(0.0));
            CHECK(world->shape_pose_W(1).position.y() ==
                  Approx(0.25 + phase_m - 0.6).margin(1.0e-9));
        }
    }
}

TEST_CASE(
    "rigid world: a ball bounces off a ring where it touches; thin and open meshes are refused") {
    const SolidShape ring = touchable(make_torus(0.06, 0.02, 48, 24));
    for (const double phase_m : {0.013, 0.05, 0.085}) {
        CAPTURE(phase_m);
        const RigidBodyPlan ball = make_flying(SphereShape{0.02}, {0.06, 0.04 + phase_m, 0.0});
        const auto world = make_rigid_world(
            plan_weightless({plan_wall(ring, Vector3::Zero()), with_restitution(ball, 1.0)}));
        world->step(kStep_s);
        // Down by the phase, and up again by what is left of 0.1 m.
        CHECK(world->shape_pose_W(1).position.y() == Approx(0.04 + 0.1 - phase_m).margin(2.0e-3));
        CHECK(world->state(1).velocity_W.linear.y() == Approx(100.0).epsilon(0.01));
    }
    const TriangleMesh box = *make_box({0.2, 0.1, 0.2});
    std::vector<TriangleCorners> open = box.triangles();
    open.pop_back();
    const auto refuse = [](const Expected<TriangleMesh>& mesh) {
        const auto made = RigidWorld::create(plan_awake(
            {plan_wall(touchable(mesh), Vector3::Zero()), plan_ball(0.03, {0.0, 0.1, 0.0})}));
        REQUIRE_FALSE(made);
        return to_sentence(made.error());
    };
    CHECK(refuse(make_bowl(0.1, 0.099, 48, 12)).find("thinner") != std::string::npos);
    const std::string told = refuse(TriangleMesh::build(box.vertices_B(), open));
    CHECK(told.find("body 0") != std::string::npos);
    CHECK(told.find("open") != std::string::npos);
    RigidWorldPlan plan =
        plan_awake({plan_wall(touchable(make_channel(0.1, 0.02, 0.2)), Vector3::Zero()),
                    plan_ball(0.03, {0.0, 0.1, 0.0})});
    plan.bodies[0].sampled = *SampledShape::make(plan.bodies[0].shape, {.n_cells = 32});
    const auto world = make_rigid_world(plan);
    run(*world, 1.0);
    CHECK(world->shape_pose_W(1).position.y() == Approx(0.05).margin(1.0e-3));
}

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
