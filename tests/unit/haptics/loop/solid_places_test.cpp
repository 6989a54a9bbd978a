#include "haptics/loop/solid_places.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

using namespace fulcrum;

namespace {

HapticPlan make_two() {
    HapticPlan plan;
    plan.solids.push_back({.body = 4, .shape = SphereShape{}});
    plan.solids.push_back(
        {.body = 7, .shape = SphereShape{}, .initial_pose_W = Pose::at(Vector3(1, 2, 3))});
    return plan;
}

}  // namespace

TEST_CASE("solid places: where nobody tells, solids are where they began") {
    SolidPlaces places(make_two());
    REQUIRE(places.step(nullptr));
    REQUIRE(places.poses_W().size() == 2);
    CHECK(places.poses_W()[1].position == Vector3(1, 2, 3));
    CHECK(places.put() == 0U);
    CHECK(places.body_of(0) == 4);
    CHECK(places.body_of(1) == 7);
    CHECK(places.body_of(2) == kNoBody);
    CHECK(places.body_of(kNoBody) == kNoBody);
}

TEST_CASE("solid places: the world's poses hold, and each new placement is told once") {
    SolidPlaces places(make_two());
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
