// Where a segment meets one triangle, and the first of several asked together: segment_triangle.h, triangle_batch.h.
#include "haptics/collision/segment_triangle.h"

#include "haptics/collision/triangle_batch.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace fulcrum {
namespace {

PreparedTriangle make_numbered(std::int32_t index) {
    return prepare_triangle({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, index);
}
const PreparedTriangle kTriangle = make_numbered(42);

// What the triangle tells, alone and in a batch.
SegmentHit meet(const Vector3& from, const Vector3& to) {
    TriangleBatch batch;
    batch.add(kTriangle);
    const SegmentHit alone = meet(kTriangle, from, to);
    const SegmentHit together = batch.find_nearest_hit(from, to);
    CHECK(together.triangle == alone.triangle);
    CHECK(together.t == alone.t);
    CHECK(together.side == alone.side);
    return alone;
}

TEST_CASE("segment and triangle: t, side and number of a meeting from the front and from behind") {
    const Vector3 above(0.2, 0.3, 3.0);
    const Vector3 below(0.2, 0.3, -1.0);
    const SegmentHit down = meet(above, below);
    CHECK(down.triangle == 42);
    CHECK(down.t == 0.75);
    CHECK(down.side == 1);
    const SegmentHit up = meet(below, above);
    CHECK(up.t == 0.25);
    CHECK(up.side == -1);
}

TEST_CASE("segment and triangle: corners and edges belong to it, a step beside does not") {
    const auto falls_on = [](double x, double y) {
        return meet({x, y, 1.0}, {x, y, -1.0}).found();
    };
    for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(0.0, 1.0),
                               std::pair(0.5, 0.5), std::pair(0.25, 0.0), std::pair(0.0, 0.75)}) {
        CHECK(falls_on(x, y));
    }
    CHECK_FALSE(falls_on(0.25, -5e-324));
    CHECK_FALSE(falls_on(-5e-324, 0.25));
    CHECK_FALSE(falls_on(std::nextafter(0.5, 1.0), 0.5));
    CHECK(falls_on(std::nextafter(0.5, 0.0), 0.5));
}

TEST_CASE("segment and triangle: an end in the plane is a meeting, an end one step above is none") {
    const Vector3 above(0.25, 0.25, 1.0);
    const Vector3 inside(0.25, 0.25, 0.0);
    CHECK(meet(above, inside).t == 1.0);
    CHECK(meet(inside, above).t == 0.0);
    CHECK(meet(inside, above).side == -1);  // it came from behind, to go up
    CHECK(meet(above, {0.25, 0.25, -5e-324}).found());
    CHECK_FALSE(meet(above, {0.25, 0.25, 1e-300}).found());
    CHECK_FALSE(meet(above, {0.25, 0.25, 5e-324}).found());
    // A single point meets only where it lies.
    CHECK(meet(inside, inside).found());
    CHECK_FALSE(meet({1.0, 1.0, 0.0}, {1.0, 1.0, 0.0}).found());
    CHECK_FALSE(meet({0.25, 0.25, 1e-20}, {0.25, 0.25, 1e-20}).found());
    // One that touches the box alone.
    CHECK_FALSE(meet({1.0, 1.0, 0.0}, {1.0, 1.0, 2.0}).found());
}

TEST_CASE("segment and triangle: in its plane the first edge is met, or the start if inside") {
    const SegmentHit across = meet({-1.0, 0.25, 0.0}, {1.0, 0.25, 0.0});
    CHECK(across.t == 0.5);
    CHECK(across.side == 0);
    CHECK(meet({0.25, 0.25, 0.0}, {5.0, 0.25, 0.0}).t == 0.0);
    CHECK_FALSE(meet({-1.0, 1.25, 0.0}, {1.0, 1.25, 0.0}).found());
    CHECK_FALSE(meet({-1.0, 0.25, 0.0}, {-0.5, 0.25, 0.0}).found());
    CHECK_FALSE(meet({2.0, 0.0, 0.0}, {3.0, 0.0, 0.0}).found());
    CHECK(meet({3.0, 0.0, 0.0}, {-3.0, 0.0, 0.0}).t == Approx(1.0 / 3.0).epsilon(1e-15));
    CHECK(meet({-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}).t == 1.0);
    // Also in a plane that is not one of the axes', and for one seen from its other side.
    const PreparedTriangle tilted = prepare_triangle({0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 7);
    CHECK(meet(tilted, {3.0, -1.0, -1.0}, {-1.0, 1.0, 1.0}).t == 0.5);
    // Each edge belongs to it, also along itself.
    const std::array corners{kTriangle.a, kTriangle.b, kTriangle.c};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3& from = corners[i];
        const Vector3& to = corners[(i + 1) % 3];
        const Vector3 near = 0.75 * from + 0.25 * to;
        const SegmentHit along = meet(near, 0.25 * from + 0.75 * to);
        CHECK(along.found());
        CHECK(along.t == 0.0);
        CHECK(meet(near, near).found());
    }
}

TEST_CASE("segment and triangle: the nearer of two comes first, of equals the lower number") {
    const SegmentHit near{0.25, 3, 1};
    const SegmentHit far{0.5, 2, 1};
    const SegmentHit equal{0.25, 4, -1};
    CHECK(near.is_before(far));
    CHECK_FALSE(far.is_before(near));
    CHECK(near.is_before(equal));
    CHECK_FALSE(equal.is_before(near));
    CHECK(near.is_before(SegmentHit{}));
    TriangleBatch batch;
    for (const std::int32_t index : {9, 3, 5}) {
        batch.add(make_numbered(index));
    }
    const SegmentHit hit = batch.find_nearest_hit({0.2, 0.2, 1.0}, {0.2, 0.2, -1.0});
    CHECK(hit.triangle == 3);
    CHECK(hit.t == 0.5);
    CHECK(hit.side == 1);
}

TEST_CASE("segment and triangle: a height that rounding eats in every sign is a meeting still") {
    // Seen from its middle each edge spans products below a half: times the smallest number, zero.
    const PreparedTriangle even =
        prepare_triangle({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, 0.875, 0.0}, 1);
    const Vector3 middle(0.5, 0.29, 0.0);
    const Vector3 just_above(0.5, 0.29, 5e-324);
    REQUIRE(orientation(just_above, middle, even.a, even.b) == 0);
    REQUIRE(orientation(just_above, middle, even.b, even.c) == 0);
    REQUIRE(orientation(just_above, middle, even.c, even.a) == 0);
    CHECK(meet(even, just_above, middle).found());
    CHECK(meet(even, middle, just_above).found());
}

// On a coarse grid, so that planes, edges and corners are met exactly, or anywhere.
Vector3 draw_point(Random& random, bool on_grid) {
    const Vector3 any = random.in_cube();
    return on_grid ? Vector3(std::round(3.0 * any.x()), std::round(3.0 * any.y()),
                             std::round(3.0 * any.z()))
                   : any;
}

std::vector<PreparedTriangle> draw_triangles(Random& random, std::size_t n, bool on_grid) {
    std::vector<PreparedTriangle> made;
    while (made.size() < n) {
        const Vector3 a = draw_point(random, on_grid);
        const Vector3 b = draw_point(random, on_grid);
        const PreparedTriangle one = prepare_triangle(a, b, draw_point(random, on_grid),
                                                      static_cast<std::int32_t>(made.size()));
        if (one.doubled_area.norm() > 0.0) {
            made.push_back(one);
        }
    }
    return made;
}

SegmentHit ask_each(const std::vector<PreparedTriangle>& triangles, const Vector3& from,
                    const Vector3& to) {
    SegmentHit nearest;
    for (const PreparedTriangle& triangle : triangles) {
        const SegmentHit hit = meet(triangle, from, to);
        nearest = hit.is_before(nearest) ? hit : nearest;
    }
    return nearest;
}

TEST_CASE("triangle batch: its answer is to the bit that of asking each triangle, for any number") {
    Random random(53);
    TriangleBatch batch;
    int n_hits = 0;
    int n_missed = 0;
    for (std::size_t n = 0; n <= TriangleBatch::kCapacity; ++n) {
        for (const bool on_grid : {false, true}) {
            for (int round = 0; round < 40; ++round) {
                // What was in it before is gone.
                batch.clear();
                const std::vector<PreparedTriangle> triangles = draw_triangles(random, n, on_grid);
                for (const PreparedTriangle& triangle : triangles) {
                    REQUIRE_FALSE(batch.is_full());
                    batch.add(triangle);
                }
                REQUIRE(batch.size() == n);
                for (int i = 0; i < 20; ++i) {
                    const Vector3 from = draw_point(random, on_grid);
                    const Vector3 to = draw_point(random, on_grid);
                    const SegmentHit together = batch.find_nearest_hit(from, to);
                    const SegmentHit each = ask_each(triangles, from, to);
                    REQUIRE(together.triangle == each.triangle);
                    REQUIRE(together.t == each.t);
                    REQUIRE(together.side == each.side);
                    ++(each.found() ? n_hits : n_missed);
                }
            }
        }
    }
    CHECK(batch.is_full());
    CHECK(n_hits > 10000);
    CHECK(n_missed > 10000);
}

TEST_CASE("triangle batch: what rounding puts on the wrong side of a plane is not left out") {
    Random random(53);
    TriangleBatch batch;
    int n_met = 0;
    int n_missed = 0;
    for (int round = 0; round < 2000; ++round) {
        const std::vector<PreparedTriangle> triangles = draw_triangles(random, 1, false);
        const PreparedTriangle& one = triangles.front();
        batch.clear();
        batch.add(one);
        // In the plane but for rounding, seen from either side.
        const Vector3 middle = one.a + 0.3 * (one.b - one.a) + 0.4 * (one.c - one.a);
        for (const double side : {1.0, -1.0}) {
            const Vector3 from = middle + side * one.doubled_area;
            const SegmentHit each = ask_each(triangles, from, middle);
            REQUIRE(batch.find_nearest_hit(from, middle).triangle == each.triangle);
            ++(each.found() ? n_met : n_missed);
        }
    }
    CHECK(n_met > 1000);
    CHECK(n_missed > 1000);
}

}  // namespace
}  // namespace fulcrum
