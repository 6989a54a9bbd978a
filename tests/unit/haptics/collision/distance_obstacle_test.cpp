#include "haptics/collision/distance_obstacle.h"

#include "tests/support/distance_bodies.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kLevel_m = 5.0e-9;

TEST_CASE("distance obstacle: a way stops where the surface is, whatever the function's slope") {
    for (const double bound : {1.0, 3.0}) {
        DistanceObstacle ball(std::make_shared<BallFunction>(0.5, 2.0, bound), 0.0);
        const CastHit hit = ball.cast({.from_B = Vector3(0.0, 2.0, 0.0),
                                       .to_B = Vector3(0.0, 0.0, 0.0),
                                       .level_m = kLevel_m});
        REQUIRE(hit.found());
        CHECK(hit.t == Approx(0.75).epsilon(1e-6));
        const Vector3 there(0.0, 2.0 * (1.0 - hit.t), 0.0);
        CHECK(ball.find_gap(0, there).gap_m >= 0.9 * kLevel_m);
        CHECK(ball.find_gap(0, Vector3(0.0, 0.7, 0.0)).gap_m == Approx(0.2));
        CHECK(ball.find_gap(0, Vector3(0.0, 0.7, 0.0)).normal_B == Vector3::UnitY());
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
            obstacle.cast({.from_B = from, .to_B = to, .level_m = kLevel_m, .reach_m = 0.1});
        const Vector3 end = from + std::min(hit.t, 1.0) * (to - from);
        REQUIRE(obstacle.find_gap(0, end).gap_m > 0.0);
        REQUIRE(end.y() > 0.0);
        n_hits += hit.found() ? 1 : 0;
    }
    CHECK(n_hits > 800);
    CHECK(n_hits < 1300);
}

TEST_CASE(
    "distance obstacle: along the surface a way is free to its end, and into a bend it is not") {
    const auto ring = std::make_shared<RingFunction>(1.0, 0.3);
    DistanceObstacle obstacle(ring, 0.0);
    const double gap_m = 2.0 * kLevel_m;
    // Over the tube's outside the surface falls away on all sides.
    const Vector3 outside(1.3 + gap_m, 0.0, 0.0);
    CHECK_FALSE(obstacle
                    .cast({.from_B = outside,
                           .to_B = outside + Vector3(0.0, 0.02, 0.05),
                           .level_m = kLevel_m})
                    .found());
    // In the hole it comes up along the ring.
    const Vector3 inside(0.7 - gap_m, 0.0, 0.0);
    const Vector3 along(0.0, 0.0, 0.05);
    const CastHit hit =
        obstacle.cast({.from_B = inside, .to_B = inside + along, .level_m = kLevel_m});
    REQUIRE(hit.found());
    CHECK(obstacle.find_gap(0, inside + hit.t * along).gap_m >= 0.9 * kLevel_m);
}

TEST_CASE("distance obstacle: from within out is free and further in is not") {
    DistanceObstacle ball(std::make_shared<BallFunction>(0.5), 0.0);
    const Vector3 from(0.0, 0.4, 0.0);
    const auto go = [&](const Vector3& to) {
        return ball.cast({.from_B = from, .to_B = to, .level_m = kLevel_m});
    };
    CHECK_FALSE(go(Vector3(0.0, 0.9, 0.0)).found());
    CHECK(go(Vector3(0.0, 0.1, 0.0)).t == 0.0);
    CHECK(ball.find_nearest(from, kLevel_m) == 0);
    CHECK(ball.find_nearest(Vector3(0.0, 0.6, 0.0), kLevel_m) == -1);
}

}  // namespace
}  // namespace fulcrum
