#include "haptics/collision/convex_cursor.h"

#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kLevel_m = 1.0e-10;

TEST_CASE("convex cursor: a box on a box stops by its face, on a mesh of a box alike") {
    const Vector3 half(0.5, 0.5, 0.5);
    const ConvexBody cursor = make_convex_cursor(BoxShape{{0.1, 0.2, 0.3}});
    ConvexObstacle shape(make_convex_solid(BoxShape{half}), cursor);
    ConvexMeshObstacle mesh(touchable(make_box(2.0 * half)), cursor);
    for (Obstacle* obstacle : {static_cast<Obstacle*>(&shape), static_cast<Obstacle*>(&mesh)}) {
        const auto cast = [&](const Vector3& from, const Vector3& to) {
            return obstacle->cast({.from_B = from, .to_B = to, .level_m = kLevel_m});
        };
        CHECK(cast({0.1, 2.0, 0.2}, {0.1, 0.0, 0.2}).t == Approx(0.65).epsilon(1e-9));
        CHECK(cast({0.1, 0.1, 2.0}, {0.1, 0.1, 0.0}).t == Approx(0.6).epsilon(1e-9));
        // Past its side, by a hair.
        CHECK_FALSE(cast({0.6001, 2.0, 0.2}, {0.6001, -2.0, 0.2}).found());
        CHECK(cast({0.5999, 2.0, 0.2}, {0.5999, -2.0, 0.2}).found());
        // Turned by a right angle about z, its sides are exchanged.
        obstacle->turn(
            AngleAxis(0.5 * 3.14159265358979323846, Vector3::UnitZ()).toRotationMatrix());
        CHECK(cast({0.1, 2.0, 0.2}, {0.1, 0.0, 0.2}).t == Approx(0.7).epsilon(1e-9));
        CHECK(obstacle->find_nearest({0.0, 0.59, 0.0}, kLevel_m) >= 0);
        CHECK(obstacle->find_nearest({0.0, 0.61, 0.0}, kLevel_m) == -1);
    }
}

TEST_CASE("convex cursor: no way of any cursor through any body ends nearer than it stops") {
    const std::vector<SolidShape> shapes{BoxShape{{0.2, 0.1, 0.3}}, CapsuleShape{0.1, 0.2},
                                         CylinderShape{0.2, 0.1}, SphereShape{0.15}};
    Random random(5);
    int n_hits = 0;
    int n_ways = 0;
    for (const SolidShape& cursor : shapes) {
        for (const SolidShape& solid : shapes) {
            ConvexObstacle obstacle(make_convex_solid(solid), make_convex_cursor(cursor));
            for (int i = 0; i < 40; ++i) {
                obstacle.turn(random.turn(3.0).toRotationMatrix());
                const Vector3 from = random.direction();
                const Vector3 to = random.in_cube();
                const CastHit hit =
                    obstacle.cast({.from_B = from, .to_B = to, .level_m = kLevel_m});
                const double end = std::min(hit.t, 1.0);
                for (int k = 0; k <= 20; ++k) {
                    REQUIRE(obstacle.find_gap(0, from + end * k / 20.0 * (to - from)).gap_m >=
                            0.5 * kLevel_m);
                }
                if (hit.found()) {
                    ++n_hits;
                    CHECK(obstacle.find_gap(0, from + hit.t * (to - from)).gap_m <= 2.0 * kLevel_m);
                }
                ++n_ways;
            }
        }
    }
    CHECK(n_hits > n_ways / 5);
    CHECK(n_hits < n_ways);
}

TEST_CASE("convex cursor: a hull of a box's corners is the box, but for its rounding") {
    const auto hull = make_hull_shape({{-1, -2, -3},
                                       {1, -2, -3},
                                       {-1, 2, -3},
                                       {1, 2, -3},
                                       {-1, -2, 3},
                                       {1, -2, 3},
                                       {-1, 2, 3},
                                       {1, 2, 3}});
    REQUIRE(hull);
    const ConvexBody body = make_convex_solid(*hull);
    CHECK(body.points->size() == 8);
    CHECK(body.core.bounding_radius_m() == Approx(std::sqrt(14.0)));
    const ConvexBody cursor = make_convex_cursor(*hull);
    CHECK(cursor.core.radius_m == Approx(1.0e-3 * std::sqrt(14.0)));
    ConvexObstacle obstacle(make_convex_solid(SphereShape{1.0}), cursor);
    CHECK(obstacle.find_gap(0, Vector3(0.0, 4.0, 0.0)).gap_m ==
          Approx(1.0 - 1.0e-3 * std::sqrt(14.0)));
}

TEST_CASE("convex cursor: what it remembers of a mesh changes no answer, however the body turns") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 20, 0.1, 8.0));
    const ConvexBody cursor = make_convex_cursor(BoxShape{{0.05, 0.03, 0.08}});
    ConvexMeshObstacle remembering(mesh, cursor);
    Wanderer wanderer(6);
    Random random(9);
    Vector3 from = 1.3 * wanderer.next();
    Matrix3 turned = Matrix3::Identity();
    int n_hits = 0;
    for (int i = 0; i < 1500; ++i) {
        if (i % 50 == 0) {
            // The cursor turns where it is free.
            from = 1.3 * wanderer.next();
            turned = random.turn(1.0).toRotationMatrix();
            remembering.turn(turned);
        }
        const Vector3 to = wanderer.next() * (1.12 + 0.1 * std::sin(0.1 * i));
        ConvexMeshObstacle fresh(mesh, cursor);
        fresh.turn(turned);
        const CastQuestion question{
            .from_B = from, .to_B = to, .level_m = kLevel_m, .reach_m = 0.004};
        const CastHit expected = fresh.cast(question);
        const CastHit hit = remembering.cast(question);
        REQUIRE(hit.t == Approx(expected.t).margin(1e-9));
        // Free of every triangle there, as asked of each.
        const Vector3 there = from + std::min(hit.t, 1.0) * (to - from);
        REQUIRE(remembering.find_nearest(there, 0.4 * kLevel_m) == -1);
        from = there;
        n_hits += hit.found() ? 1 : 0;
    }
    CHECK(n_hits > 100);
}

}  // namespace
}  // namespace fulcrum
