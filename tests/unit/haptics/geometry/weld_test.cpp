#include "haptics/geometry/weld.h"

#include <catch2/catch.hpp>

#include <random>

namespace fulcrum {
namespace {

TEST_CASE("weld: each vertex becomes the first kept one within the tolerance, as all tried say") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (const double tolerance_m : {0.003, 0.05, 0.3}) {
        std::vector<Vector3> vertices;
        for (int i = 0; i < 1500; ++i) {
            vertices.emplace_back(unit(random), unit(random), 0.1 * unit(random));
        }
        std::vector<std::int32_t> kept;
        std::vector<std::int32_t> expected;
        for (std::int32_t i = 0; i < 1500; ++i) {
            std::int32_t becomes = i;
            for (const std::int32_t other : kept) {
                if ((vertices[static_cast<std::size_t>(i)] -
                     vertices[static_cast<std::size_t>(other)])
                        .norm() <= tolerance_m) {
                    becomes = other;
                    break;
                }
            }
            expected.push_back(becomes);
            if (becomes == i) {
                kept.push_back(i);
            }
        }
        CHECK(compute_welded_indices(vertices, tolerance_m) == expected);
        CHECK(kept.size() < 1500);
    }
}

TEST_CASE("weld: neighbours on two sides of a cell's wall find each other") {
    for (int axis = 0; axis < 3; ++axis) {
        for (int wall = -3; wall <= 3; ++wall) {
            Vector3 before = Vector3(0.33, 0.33, 0.33);
            before[axis] = 0.2 * wall - 1e-9;
            Vector3 after = before;
            after[axis] = 0.2 * wall + 1e-9;
            CHECK(compute_welded_indices(std::vector<Vector3>{before, after}, 0.1) ==
                  std::vector<std::int32_t>{0, 0});
        }
    }
}

TEST_CASE("weld: coordinates enormous against the tolerance neither weld nor fail") {
    const std::vector<Vector3> vertices{Vector3(1e30, 0.0, 0.0), Vector3(-1e30, 0.0, 0.0),
                                        Vector3(1e30, 0.0, 0.0)};
    CHECK(compute_welded_indices(vertices, 1e-300) == std::vector<std::int32_t>{0, 1, 0});
}

}  // namespace
}  // namespace fulcrum
