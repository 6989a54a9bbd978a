// What a cursor is cast against: mesh_obstacle.h for balls, convex_cursor.h for any other, distance_obstacle.h for functions.
#include "haptics/collision/convex_cursor.h"
#include "haptics/collision/convex_mesh_obstacle.h"
#include "haptics/collision/distance_obstacle.h"
#include "haptics/collision/mesh_obstacle.h"
#include "haptics/geometry/shape.h"
#include "tests/support/distance_bodies.h"
#include "tests/support/nearest_point.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kRadius_m = 0.1;
constexpr double kLevel_m = 1.0e-10;
constexpr double kByFunction_m = 5.0e-9;

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
        MeshObstacle fresh(mesh, kRadius_m);
        const Vector3 to = wanderer.next() * (1.15 + 0.1 * std::sin(0.02 * i));
        const CastQuestion question{
            .from_B = from, .to_B = to, .level_m = kLevel_m, .reach_m = 0.004};
        const CastHit expected = fresh.cast(question);
        const CastHit hit = remembering.cast(question);
        REQUIRE(hit.t == Approx(expected.t).margin(1e-9));
        from += std::min(hit.t, 1.0) * (to - from);
    }
}

TEST_CASE("convex cursor: one that has turned is met where the plane that kept it off is passed") {
    const ConvexBody cursor = make_convex_cursor(BoxShape{{0.3, 0.05, 0.05}});
    const ConvexBody block = make_convex_solid(BoxShape{Vector3::Constant(0.1)});
    ConvexObstacle shape(block, cursor);
    ConvexMeshObstacle mesh(touchable(make_box(Vector3::Constant(0.2))), cursor);
    const Matrix3 turned =
        Quaternion(AngleAxis(0.5 * std::numbers::pi, Vector3::UnitZ())).toRotationMatrix();
    const Vector3 above(0.0, 0.3, 0.0);
    for (Obstacle* obstacle : {static_cast<Obstacle*>(&shape), static_cast<Obstacle*>(&mesh)}) {
        CHECK(obstacle->turn(turned));
        const CastQuestion stays{.from_B = above, .to_B = above, .level_m = kLevel_m};
        const CastHit hit = obstacle->cast(stays);
        REQUIRE(hit.found());
        CHECK(hit.t == 0.0);
        // It reaches 0.3 down where there is room for 0.2.
        const Gap gap = obstacle->find_gap(hit.feature, above);
        CHECK((gap.normal_B - Vector3::UnitY()).norm() < 1.0e-6);
        CHECK(gap.gap_m == Approx(-0.1).margin(1.0e-6));
        // As far up as it says there is room; and a turn that ends beyond the block with its plane between is no turn through it.
        const Vector3 higher(0.0, 0.4 + 2.0 * kLevel_m, 0.0);
        CHECK_FALSE(obstacle->cast({.from_B = above, .to_B = higher, .level_m = kLevel_m}).found());
        CHECK(obstacle->cast({.from_B = above, .to_B = -higher, .level_m = kLevel_m}).found());
        obstacle->keep_turn();
        CHECK_FALSE(obstacle->turn(turned));
        CHECK(obstacle->find_nearest(higher, 0.0) == -1);
        CHECK(obstacle->find_nearest(higher, 1.0e-6) != -1);
        (void)obstacle->turn(Matrix3::Identity());
        obstacle->keep_turn();
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
        obstacle->turn(AngleAxis(0.5 * std::numbers::pi, Vector3::UnitZ()).toRotationMatrix());
        obstacle->keep_turn();
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
                obstacle.keep_turn();
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
    std::vector<Vector3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back(i & 1 ? 1.0 : -1.0, i & 2 ? 2.0 : -2.0, i & 4 ? 3.0 : -3.0);
    }
    const auto hull = make_hull_shape(corners);
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

CastHit cast_on(DistanceObstacle& obstacle, const Vector3& from, const Vector3& to) {
    return obstacle.cast({.from_B = from, .to_B = to, .level_m = kByFunction_m});
}

TEST_CASE("distance obstacle: a way stops where the surface is, whatever the function's slope") {
    for (const double bound : {1.0, 3.0}) {
        CAPTURE(bound);
        DistanceObstacle ball(std::make_shared<BallFunction>(0.5, 2.0, bound), 0.0);
        const CastHit hit = cast_on(ball, {0.0, 2.0, 0.0}, Vector3::Zero());
        REQUIRE(hit.found());
        CHECK(hit.t == Approx(0.75).epsilon(1e-6));
        CHECK(ball.find_gap(0, {0.0, 2.0 * (1.0 - hit.t), 0.0}).gap_m >= 0.9 * kByFunction_m);
        CHECK(ball.find_gap(0, {0.0, 0.7, 0.0}).gap_m == Approx(0.2));
        CHECK(ball.find_gap(0, {0.0, 0.7, 0.0}).normal_B == Vector3::UnitY());
    }
}

TEST_CASE("distance obstacle: no way leads through a plate, however thin, fast or oblique") {
    const auto plate = std::make_shared<PlateFunction>(1.0, 1.0e-5);
    Random random(8);
    int n_hits = 0;
    for (int i = 0; i < 2000; ++i) {
        DistanceObstacle obstacle(plate, i % 2 == 0 ? 0.0 : 0.01);
        const Vector3 from(0.9 * random.uniform(), 0.011 + std::abs(random.uniform()),
                           0.9 * random.uniform());
        const Vector3 to(0.9 * random.uniform(), 0.5 * random.uniform(), 0.9 * random.uniform());
        const CastHit hit =
            obstacle.cast({.from_B = from, .to_B = to, .level_m = kByFunction_m, .reach_m = 0.1});
        const Vector3 end = from + std::min(hit.t, 1.0) * (to - from);
        REQUIRE(obstacle.find_gap(0, end).gap_m > 0.0);
        REQUIRE(end.y() > 0.0);
        n_hits += hit.found() ? 1 : 0;
    }
    CHECK(n_hits > 800);
    CHECK(n_hits < 1300);
}

TEST_CASE("distance obstacle: along the surface a way is free, into a bend or further in not") {
    DistanceObstacle ring(std::make_shared<RingFunction>(1.0, 0.3), 0.0);
    const double gap_m = 2.0 * kByFunction_m;
    // Over the tube's outside the surface falls away on all sides.
    const Vector3 outside(1.3 + gap_m, 0.0, 0.0);
    CHECK_FALSE(cast_on(ring, outside, outside + Vector3(0.0, 0.02, 0.05)).found());
    // In the hole it comes up along the ring.
    const Vector3 inside(0.7 - gap_m, 0.0, 0.0);
    const Vector3 along(0.0, 0.0, 0.05);
    const CastHit hit = cast_on(ring, inside, inside + along);
    REQUIRE(hit.found());
    CHECK(ring.find_gap(0, inside + hit.t * along).gap_m >= 0.9 * kByFunction_m);
    DistanceObstacle ball(std::make_shared<BallFunction>(0.5), 0.0);
    const Vector3 within(0.0, 0.4, 0.0);
    CHECK_FALSE(cast_on(ball, within, {0.0, 0.9, 0.0}).found());
    CHECK(cast_on(ball, within, {0.0, 0.1, 0.0}).t == 0.0);
    CHECK(ball.find_nearest(within, kByFunction_m) == 0);
    CHECK(ball.find_nearest({0.0, 0.6, 0.0}, kByFunction_m) == -1);
}

}  // namespace
}  // namespace fulcrum
