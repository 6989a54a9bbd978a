#include "haptics/collision/mesh_obstacle.h"

#include "haptics/geometry/shape.h"
#include "tests/support/nearest_point.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kRadius_m = 0.1;
constexpr double kLevel_m = 1.0e-10;

double gap_m(const CollisionMesh& mesh, const Vector3& at) {
    return (at - find_nearest_on_mesh(mesh, at)).norm() - kRadius_m;
}

TEST_CASE("mesh obstacle: a ball stops where it first touches, and nothing is touched before") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 6, 0.2, 5.0));
    Random random(4);
    int n_hits = 0;
    for (int i = 0; i < 600; ++i) {
        MeshObstacle obstacle(mesh, kRadius_m);
        const Vector3 from = 1.5 * random.direction();
        const Vector3 to =
            i % 3 == 0 ? Vector3(from + 0.1 * random.in_cube()) : Vector3(2.0 * random.in_cube());
        const CastHit hit = obstacle.cast(
            {.from_B = from, .to_B = to, .level_m = kLevel_m, .reach_m = i % 2 == 0 ? 1.0 : 0.01});
        const double end = std::min(hit.t, 1.0);
        for (int k = 0; k <= 40; ++k) {
            REQUIRE(gap_m(*mesh, from + end * k / 40.0 * (to - from)) >= 0.9 * kLevel_m);
        }
        if (hit.found()) {
            ++n_hits;
            const Vector3 there = from + hit.t * (to - from);
            CHECK(gap_m(*mesh, there) <= 1.2 * kLevel_m);
            const Gap gap = obstacle.find_gap(hit.feature, there);
            CHECK(gap.gap_m <= 1.2 * kLevel_m);
            CHECK(gap.normal_B.dot(to - from) < 0.0);
        }
    }
    CHECK(n_hits > 150);
    CHECK(n_hits < 550);
}

TEST_CASE("mesh obstacle: what it remembers of earlier ways changes no answer") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 12, 0.1, 8.0));
    MeshObstacle remembering(mesh, kRadius_m);
    Wanderer wanderer(6);
    Vector3 from = 1.25 * wanderer.next();
    for (int i = 0; i < 3000; ++i) {
        const Vector3 to = wanderer.next() * (1.15 + 0.1 * std::sin(0.02 * i));
        const CastQuestion question{
            .from_B = from, .to_B = to, .level_m = kLevel_m, .reach_m = 0.004};
        MeshObstacle fresh(mesh, kRadius_m);
        const CastHit expected = fresh.cast(question);
        const CastHit hit = remembering.cast(question);
        REQUIRE(hit.t == Approx(expected.t).margin(1e-9));
        from += std::min(hit.t, 1.0) * (to - from);
    }
}

TEST_CASE("mesh obstacle: a plane that the way does not sink through spares what lies below it") {
    const auto mesh = touchable(make_plate(2.0, 2.0, 8));
    MeshObstacle obstacle(mesh, kRadius_m);
    const Vector3 up = Vector3::UnitY();
    CastQuestion question{.from_B = Vector3(-0.3, kRadius_m + kLevel_m, 0.1),
                          .to_B = Vector3(0.4, kRadius_m + kLevel_m, 0.05),
                          .level_m = kLevel_m,
                          .reach_m = 0.1,
                          .normals_B = std::span(&up, 1)};
    CHECK_FALSE(obstacle.cast(question).found());
    // It spares nothing that the way does sink into.
    question.to_B.y() -= 0.01;
    CHECK(obstacle.cast(question).found());
}

TEST_CASE("mesh obstacle: the nearest triangle is found only when it is near enough") {
    const auto mesh = touchable(make_box(Vector3::Ones()));
    const MeshObstacle obstacle(mesh, kRadius_m);
    CHECK(obstacle.find_nearest(Vector3(0.0, 0.61, 0.0), kLevel_m) == -1);
    const std::int32_t feature = obstacle.find_nearest(Vector3(0.1, 0.59, 0.2), kLevel_m);
    REQUIRE(feature >= 0);
    const Gap gap = obstacle.find_gap(feature, Vector3(0.1, 0.59, 0.2));
    CHECK(gap.gap_m == Approx(-0.01));
    CHECK(gap.normal_B.isApprox(Vector3::UnitY()));
    CHECK(gap.curvature_per_m == 0.0);
}

TEST_CASE("mesh obstacle: an edge bends by one over the distance, across itself, up to its faces") {
    const auto mesh = touchable(make_box(Vector3::Ones()));
    MeshObstacle obstacle(mesh, kRadius_m);
    const Vector3 at(0.5 + 0.06, 0.5 + 0.08, 0.1);
    CHECK_FALSE(obstacle
                    .cast({.from_B = at,
                           .to_B = at + Vector3(0.01, 0.0, 0.0),
                           .level_m = kLevel_m,
                           .reach_m = 0.1})
                    .found());
    const std::int32_t feature = obstacle.find_nearest(at, 0.01);
    REQUIRE(feature >= 0);
    const Gap gap = obstacle.find_gap(feature, at);
    CHECK(gap.curvature_per_m == Approx(10.0));
    CHECK(std::abs(gap.straight_B.z()) == Approx(1.0));
    // Down, towards the side x = 0.5: from the direction (0.6, 0.8) to (1, 0) is tan = 4/3 of 0.1 m; the bound of 0.3 is nearer.
    CHECK(obstacle.find_bend(feature, at, Vector3(0.8, -0.6, 0.0)) == Approx(0.03));
    const Vector3 steep(0.5 + 0.0995, 0.5 + 0.00998749, 0.1);
    CHECK(obstacle.find_bend(feature, steep, Vector3(0.0998749, -0.995, 0.0)) ==
          Approx(0.1 * 0.00998749 / 0.0995).epsilon(1e-4));
}

}  // namespace
}  // namespace fulcrum
