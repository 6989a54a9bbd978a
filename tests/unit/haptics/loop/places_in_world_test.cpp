#include "haptics/loop/solid_places.h"
#include "haptics/loop/workspace.h"
#include "haptics/math/rotation.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

using namespace fulcrum;

namespace {

constexpr double kRounding = 1e-12;

Workspace make_workspace() {
    return {{Vector3(1.0, 2.0, 3.0), compute_exp(Vector3(0.0, 1.5707963267948966, 0.0))}, 4.0};
}

HapticPlan make_two() {
    HapticPlan plan;
    plan.solids.push_back({.body = 4, .shape = SphereShape{}});
    plan.solids.push_back(
        {.body = 7, .shape = SphereShape{}, .initial_pose_W = Pose::at(Vector3(1, 2, 3))});
    return plan;
}

}  // namespace

TEST_CASE("workspace: p_W = p + R (scale p_D), there and back; forces are turned, not scaled") {
    const Pose pose_W =
        compute_world_pose(make_workspace(), {Vector3(0.1, 0.2, 0.3), Quaternion::Identity()});
    CHECK((pose_W.position - Vector3(1.0 + 1.2, 2.0 + 0.8, 3.0 - 0.4)).norm() < kRounding);
    CHECK((pose_W.orientation * Vector3::UnitZ() - Vector3::UnitX()).norm() < kRounding);
    const Pose pose_D{Vector3(0.1, -0.2, 0.05), compute_exp(Vector3(0.3, -0.2, 0.9))};
    const Pose back =
        compute_device_pose(make_workspace(), compute_world_pose(make_workspace(), pose_D));
    CHECK((back.position - pose_D.position).norm() < kRounding);
    CHECK((back.orientation.coeffs() - pose_D.orientation.coeffs()).norm() < kRounding);
    const Wrench wrench_D =
        compute_device_wrench(make_workspace(), {Vector3(1.0, 0.0, 0.0), Vector3(0.0, 2.0, 0.0)});
    CHECK((wrench_D.force - Vector3(0.0, 0.0, 1.0)).norm() < kRounding);
    CHECK((wrench_D.torque - Vector3(0.0, 2.0, 0.0)).norm() < kRounding);
    const Wrench back_W = compute_world_wrench(make_workspace(), wrench_D);
    CHECK((back_W.force - Vector3(1.0, 0.0, 0.0)).norm() < kRounding);
    // A quarter turn about y takes (x, y, z) to (z, y, -x): back by R^T it is (-z, y, x).
    const Wrench oblique_W{Vector3(4.0, 5.0, 6.0), Vector3(1.0, 2.0, 3.0)};
    const Wrench oblique_D = compute_device_wrench(make_workspace(), oblique_W);
    CHECK((oblique_D.force - Vector3(-6.0, 5.0, 4.0)).norm() < kRounding);
    CHECK((oblique_D.torque - Vector3(-3.0, 2.0, 1.0)).norm() < kRounding);
    const Wrench again_W = compute_world_wrench(make_workspace(), oblique_D);
    CHECK((again_W.force - oblique_W.force).norm() < kRounding);
    CHECK((again_W.torque - oblique_W.torque).norm() < kRounding);
}

TEST_CASE("solid places: where they began, then where the world says; each placement once") {
    SolidPlaces places(make_two());
    REQUIRE(places.step(nullptr));
    REQUIRE(places.poses_W().size() == 2);
    CHECK(places.poses_W()[1].position == Vector3(1, 2, 3));
    CHECK(places.put() == 0U);
    CHECK(places.body_of(0) == 4);
    CHECK(places.body_of(1) == 7);
    CHECK(places.body_of(2) == kNoBody);
    CHECK(places.body_of(kNoBody) == kNoBody);
    places = SolidPlaces(make_two());
    auto world = std::make_unique<WorldFrame>();
    world->solid_poses_W[0].position = Vector3(0, 5, 0);
    REQUIRE(places.step(world.get()));
    CHECK(places.poses_W()[0].position == Vector3(0, 5, 0));
    // What is heard first is news of all.
    CHECK(places.put() == 3U);
    REQUIRE(places.step(world.get()));
    CHECK(places.put() == 0U);
    world->solid_placements[1] = 1;
    REQUIRE(places.step(world.get()));
    CHECK(places.put() == 2U);
}

TEST_CASE("solid places: a pose that is no number leaves none, and tells nothing") {
    SolidPlaces places(make_two());
    auto world = std::make_unique<WorldFrame>();
    REQUIRE(places.step(world.get()));
    world->solid_poses_W[1].orientation.x() = std::nan("");
    world->solid_placements[0] = 1;
    CHECK_FALSE(places.step(world.get()));
    CHECK(places.poses_W().empty());
    CHECK(places.put() == 0U);
    world->solid_poses_W[1] = {};
    REQUIRE(places.step(world.get()));
    CHECK(places.put() == 1U);
}
