#include "haptics/collision/triangle_batch.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace fulcrum {
namespace {

class Draw {
  public:
    Vector3 vector() { return {unit_(random_), unit_(random_), unit_(random_)}; }
    // On a coarse grid, so that planes, edges and corners are met exactly.
    Vector3 grid_point() {
        return {std::round(3.0 * unit_(random_)), std::round(3.0 * unit_(random_)),
                std::round(3.0 * unit_(random_))};
    }
    std::vector<PreparedTriangle> triangles(std::size_t n, bool on_grid) {
        std::vector<PreparedTriangle> made;
        while (made.size() < n) {
            const auto point = [&] { return on_grid ? grid_point() : vector(); };
            const PreparedTriangle one =
                prepare_triangle(point(), point(), point(), static_cast<std::int32_t>(made.size()));
            if (one.doubled_area.norm() > 0.0) {
                made.push_back(one);
            }
        }
        return made;
    }

  private:
    std::mt19937_64 random_{53};
    std::uniform_real_distribution<double> unit_{-1.0, 1.0};
};

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
    Draw draw;
    TriangleBatch batch;
    int n_hits = 0;
    int n_missed = 0;
    for (std::size_t n = 0; n <= TriangleBatch::kCapacity; ++n) {
        for (const bool on_grid : {false, true}) {
            for (int round = 0; round < 40; ++round) {
                // What was in it before is gone.
                batch.clear();
                const std::vector<PreparedTriangle> triangles = draw.triangles(n, on_grid);
                for (const PreparedTriangle& triangle : triangles) {
                    REQUIRE_FALSE(batch.is_full());
                    batch.add(triangle);
                }
                REQUIRE(batch.size() == n);
                for (int i = 0; i < 20; ++i) {
                    const Vector3 from = on_grid ? draw.grid_point() : draw.vector();
                    const Vector3 to = on_grid ? draw.grid_point() : draw.vector();
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

TEST_CASE(
    "triangle batch: ends in a plane, one step off it and at a corner are left to exact signs") {
    TriangleBatch batch;
    batch.add(prepare_triangle(Vector3(0.0, 0.0, 0.0), Vector3(1.0, 0.0, 0.0),
                               Vector3(0.0, 1.0, 0.0), 7));
    const Vector3 above(0.25, 0.25, 1.0);
    constexpr double kStep = std::numeric_limits<double>::denorm_min();
    CHECK(batch.find_nearest_hit(above, Vector3(0.25, 0.25, 0.0)).t == 1.0);
    CHECK(batch.find_nearest_hit(above, Vector3(0.25, 0.25, -kStep)).found());
    CHECK_FALSE(batch.find_nearest_hit(above, Vector3(0.25, 0.25, kStep)).found());
    // In its plane, along an edge's line, and touching the box alone.
    CHECK(batch.find_nearest_hit(Vector3(-1.0, 0.25, 0.0), Vector3(1.0, 0.25, 0.0)).t == 0.5);
    CHECK(batch.find_nearest_hit(Vector3(-1.0, 0.0, 0.0), Vector3(0.0, 0.0, 0.0)).t == 1.0);
    CHECK_FALSE(batch.find_nearest_hit(Vector3(1.0, 1.0, 0.0), Vector3(1.0, 1.0, 2.0)).found());
    // At a place, without a way.
    CHECK(batch.find_nearest_hit(Vector3(0.25, 0.25, 0.0), Vector3(0.25, 0.25, 0.0)).triangle == 7);
}

TEST_CASE("triangle batch: what rounding puts on the wrong side of a plane is not left out") {
    Draw draw;
    TriangleBatch batch;
    int n_met = 0;
    int n_missed = 0;
    for (int round = 0; round < 2000; ++round) {
        const std::vector<PreparedTriangle> triangles = draw.triangles(1, false);
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

TEST_CASE("triangle batch: of meetings equally near it tells that of the lower triangle") {
    TriangleBatch batch;
    for (const std::int32_t index : {9, 3, 5}) {
        batch.add(prepare_triangle(Vector3(0.0, 0.0, 0.0), Vector3(1.0, 0.0, 0.0),
                                   Vector3(0.0, 1.0, 0.0), index));
    }
    const SegmentHit hit = batch.find_nearest_hit(Vector3(0.2, 0.2, 1.0), Vector3(0.2, 0.2, -1.0));
    CHECK(hit.triangle == 3);
    CHECK(hit.t == 0.5);
    CHECK(hit.side == 1);
}

}  // namespace
}  // namespace fulcrum
