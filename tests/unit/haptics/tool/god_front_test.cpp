#include "haptics/tool/god_front.h"

#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace fulcrum {
namespace {

using Indices = std::set<std::pair<std::int32_t, std::int32_t>>;

struct Scene {
    std::shared_ptr<const SweptMesh> object = SweptMesh::create(make_sphere(0.03, 7).value());
    std::shared_ptr<const SweptMesh> tool = SweptMesh::create(make_box({0.04, 0.02, 0.03}).value());

    [[nodiscard]] GodFront make_front(int most = 4096) const { return {*object, *tool, most}; }
    [[nodiscard]] GodPlace place(const Pose& X_OT) const {
        return GodPlace::of(*object, *tool, X_OT);
    }
    [[nodiscard]] double find_distance_m(std::int32_t i, std::int32_t j, const Pose& X_OT) const {
        return find_nearest_features(object->triangle(i), place(X_OT).corners(tool->triangle(j)))
            .distance_m;
    }
    // Of all triangles.
    [[nodiscard]] Indices find_within(const Pose& X_OT, double within_m) const {
        Indices found;
        for (std::int32_t i = 0; i < object->n_triangles(); ++i) {
            for (std::int32_t j = 0; j < tool->n_triangles(); ++j) {
                if (find_distance_m(i, j, X_OT) <= within_m) {
                    found.emplace(i, j);
                }
            }
        }
        return found;
    }
};

Indices told_by(const GodFront& front) {
    Indices told;
    for (const std::int32_t i : front.near()) {
        const auto [at, is_new] =
            told.emplace(front.pair(i).object_triangle, front.pair(i).tool_triangle);
        CHECK(is_new);  // each once
    }
    return told;
}

// A walk round the ball, now short steps and now long ones, sometimes away.
Pose walk(Random& random, const Pose& at, double step_m) {
    Pose to = at;
    to.position += step_m * random.in_cube();
    to.orientation = (compute_exp(20.0 * step_m * random.in_cube()) * at.orientation).normalized();
    if (const double away_m = to.position.norm(); away_m > 0.07 || away_m < 0.035) {
        to.position *= 0.05 / away_m;
    }
    return to;
}

TEST_CASE("god front: of all triangles none that is near is left out, on any walk") {
    const Scene scene;
    GodFront front = scene.make_front();
    Random random(5);
    Pose at = Pose::at({0.0, 0.05, 0.0});
    std::size_t n_found = 0;
    for (int k = 0; k < 400; ++k) {
        at = walk(random, at, k % 50 == 0 ? 0.05 : 0.0005);
        const double reach_m = 0.0005 * (1 + k % 7);
        REQUIRE(front.look(scene.place(at), reach_m) == GodLook::whole);
        const Indices told = told_by(front);
        const Indices found = scene.find_within(at, reach_m);
        n_found += found.size();
        REQUIRE(std::ranges::includes(told, found));
        if (k % 3 == 0) {
            for (const std::int32_t i : front.near()) {
                front.aim(i, scene.place(at));
            }
        }
        front.tidy(scene.place(at), 4.0 * reach_m);
    }
    CHECK(n_found > 400);
}

TEST_CASE("god front: no direction tells more than the distance, and one that was aimed tells it") {
    const Scene scene;
    Random random(6);
    for (int k = 0; k < 30; ++k) {
        GodFront front = scene.make_front();
        const Pose at{Vector3(0.06 * random.in_cube().normalized()),
                      compute_exp(2.0 * random.in_cube())};
        const GodPlace place = scene.place(at);
        REQUIRE(front.look(place, 0.004) == GodLook::whole);
        for (const std::int32_t i : front.near()) {
            const GodNear& near = front.pair(i);
            const double distance_m =
                scene.find_distance_m(near.object_triangle, near.tool_triangle, at);
            const Triangle own = scene.tool->triangle(near.tool_triangle);
            CHECK(find_apart_m(near, own, place) <= distance_m);
            front.aim(i, place);
            if (distance_m > 1.0e-6) {
                CHECK(find_apart_m(near, own, place) <= distance_m);
                CHECK(find_apart_m(near, own, place) >= distance_m - 3.0 * place.rounded_m);
            }
        }
    }
}

TEST_CASE("god front: what has come apart goes from it again") {
    const Scene scene;
    GodFront front = scene.make_front();
    const Pose near_by = Pose::at({0.0, 0.0401, 0.0});
    REQUIRE(front.look(scene.place(near_by), 0.003) == GodLook::whole);
    const std::size_t many = front.size();
    CHECK(many > 20);
    CHECK_FALSE(front.near().empty());
    const Pose far_off = Pose::at({0.0, 1.0, 0.0});
    for (int k = 0; k < 200; ++k) {
        REQUIRE(front.look(scene.place(far_off), 0.003) == GodLook::whole);
        CHECK(front.near().empty());
        front.tidy(scene.place(far_off), 0.01);
    }
    CHECK(front.size() == 2);  // the roots
    // And comes back.
    REQUIRE(front.look(scene.place(near_by), 0.003) == GodLook::whole);
    CHECK(std::ranges::includes(told_by(front), scene.find_within(near_by, 0.003)));
}

TEST_CASE("god front: without room, and at places that are none, all is forgotten and told") {
    const Scene scene;
    GodFront front = scene.make_front(8);
    const Pose near_by = Pose::at({0.0, 0.0401, 0.0});
    CHECK(front.look(scene.place(near_by), 0.003) == GodLook::no_room);
    REQUIRE(front.look(scene.place(Pose::at({0.0, 1.0, 0.0})), 0.003) == GodLook::whole);
    CHECK(front.near().empty());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(front.look(scene.place(Pose::at({nan, 0.0, 0.0})), 0.003) == GodLook::no_room);
    REQUIRE(front.look(scene.place(Pose::at({0.0, 1.0, 0.0})), 0.003) == GodLook::whole);
    CHECK(front.memory_bytes() > 0);
    // Standing still uses nothing up, for however long.
    GodFront still = scene.make_front();
    REQUIRE(still.look(scene.place(near_by), 1.0e-5) == GodLook::whole);
    const Indices told = told_by(still);
    for (int k = 0; k < 1000; ++k) {
        REQUIRE(still.look(scene.place(near_by), 1.0e-5) == GodLook::whole);
    }
    CHECK(told_by(still) == told);
}

}  // namespace
}  // namespace fulcrum
