#include "haptics/geometry/hash_grid.h"

#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <set>

namespace fulcrum {
namespace {

const Box kUnit{Vector3(-1.0, -1.0, -1.0), Vector3(1.0, 1.0, 1.0)};

TEST_CASE("hash grid: what was put into a cell is found there, and nothing elsewhere") {
    HashGrid grid(kUnit, 0.01);
    Random random(4);
    std::map<std::uint64_t, std::int32_t> expected;
    while (expected.size() < 5000) {
        expected[HashGrid::to_key(grid.find_cell(random.in_cube()))] =
            static_cast<std::int32_t>(expected.size());
    }
    grid.reserve(expected.size());
    for (const auto& [key, value] : expected) {
        grid.insert(key, value);
    }
    for (const auto& [key, value] : expected) {
        REQUIRE(grid.find(key) == value);
    }
    int n_nothing = 0;
    for (int i = 0; i < 5000; ++i) {
        const std::uint64_t key = HashGrid::to_key(grid.find_cell(random.in_cube()));
        n_nothing += grid.find(key) == HashGrid::kNothing ? 1 : 0;
        REQUIRE((grid.find(key) == HashGrid::kNothing) == (expected.count(key) == 0));
    }
    CHECK(n_nothing > 4000);
}

TEST_CASE("hash grid: cells of different places have different keys") {
    std::set<std::uint64_t> keys;
    for (const std::int32_t x : {0, 1, 2, 1 << 19}) {
        for (const std::int32_t y : {0, 1, 2, 1 << 19}) {
            for (const std::int32_t z : {0, 1, 2, 1 << 19}) {
                keys.insert(HashGrid::to_key({x, y, z}));
            }
        }
    }
    CHECK(keys.size() == 64);
}

// Cells whose widened box holds a point of the segment, by asking many points.
TEST_CASE("hash grid: a segment's way leads through the cells of all its points, in order") {
    const HashGrid grid(kUnit, 0.1);
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        Vector3 from = 1.5 * random.in_cube();
        Vector3 to = 1.5 * random.in_cube();
        if (i % 3 == 0) {  // parallel to a plane of the grid
            to[i % 9 / 3] = from[i % 9 / 3];
        }
        std::map<std::uint64_t, double> left;  // and when
        double t_last = 0.0;
        grid.for_each_along(from, to, [&](std::uint64_t key, double t_leave) {
            REQUIRE(left.count(key) == 0);
            REQUIRE(t_leave >= t_last);
            t_last = t_leave;
            left[key] = t_leave;
            return true;
        });
        for (int k = 0; k <= 300; ++k) {
            const double t = k / 300.0;
            const Vector3 p = from + t * (to - from);
            if (kUnit.contains(p)) {
                // The point's cell, or right at a border its neighbour, is left no earlier than the point is passed.
                const auto cell = left.find(HashGrid::to_key(grid.find_cell(p)));
                REQUIRE(cell != left.end());
                REQUIRE(cell->second >= t - 1e-12);
            }
        }
    }
}

TEST_CASE("hash grid: a way ends when told to, beside the grid it has none, a point has one cell") {
    const HashGrid grid(kUnit, 0.1);
    int n = 0;
    grid.for_each_along(Vector3(-1.0, 0.03, 0.02), Vector3(1.0, 0.01, 0.04),
                        [&](std::uint64_t, double) { return ++n < 3; });
    CHECK(n == 3);
    n = 0;
    const auto count = [&](std::uint64_t, double) { return ++n < 1000; };
    grid.for_each_along(Vector3(-3.0, 2.0, 0.0), Vector3(3.0, 2.0, 0.0), count);
    grid.for_each_along(Vector3(1.5, 1.5, 1.5), Vector3(1.5, 1.5, 1.5), count);
    CHECK(n == 0);
    grid.for_each_along(Vector3(0.5, 0.5, 0.5), Vector3(0.5, 0.5, 0.5), count);
    CHECK(n == 1);
}

TEST_CASE("hash grid: cells are no smaller than a million along the longest side") {
    const HashGrid grid(kUnit, 1.0e-12);
    CHECK(grid.cell_m() > 2.0 / HashGrid::kMaxCells);
    CHECK(grid.cell_m() < 2.1 / HashGrid::kMaxCells);
    const HashGrid coarse(kUnit, 0.1);
    CHECK(coarse.resolves(1.0));
    CHECK_FALSE(coarse.resolves(1.0e12));
    CHECK(coarse.memory_bytes() > 0);
}

}  // namespace
}  // namespace fulcrum
