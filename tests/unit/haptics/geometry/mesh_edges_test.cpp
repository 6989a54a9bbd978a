#include "haptics/geometry/mesh_edges.h"

#include "haptics/geometry/shape.h"

#include <catch2/catch.hpp>

#include <map>
#include <utility>

namespace fulcrum {
namespace {

TEST_CASE("mesh edges: each side of each triangle is there once, those of two vertices together") {
    const auto mesh = make_torus(1.0, 0.3, 12, 7);
    const auto edges = collect_edges(mesh->triangles(), mesh->vertices_B().size());
    REQUIRE(edges.size() == 3 * mesh->triangles().size());
    std::map<std::pair<std::int32_t, std::int32_t>, int> expected;
    for (const TriangleCorners& t : mesh->triangles()) {
        for (std::size_t i = 0; i < 3; ++i) {
            expected[std::minmax({t[i], t[(i + 1) % 3]})] += 1;
        }
    }
    std::size_t n_runs = 0;
    for_each_shared_edge(edges, [&](std::span<const MeshEdge> shared) {
        ++n_runs;
        REQUIRE(shared.size() == 2);
        REQUIRE(shared[0].upwards != shared[1].upwards);
        REQUIRE(shared[0].triangle < shared[1].triangle);
        REQUIRE(expected.at({shared[0].low, shared[0].high}) == 2);
    });
    CHECK(n_runs == expected.size());
}

TEST_CASE("mesh edges: an edge knows its triangle and which way that runs") {
    const std::vector<TriangleCorners> triangles{{5, 2, 9}};
    const auto edges = collect_edges(triangles, 10);
    REQUIRE(edges.size() == 3);
    CHECK((edges[0].low == 2 && edges[0].high == 5 && !edges[0].upwards));
    CHECK((edges[1].low == 2 && edges[1].high == 9 && edges[1].upwards));
    CHECK((edges[2].low == 5 && edges[2].high == 9 && !edges[2].upwards));
    CHECK(edges[2].triangle == 0);
    CHECK(collect_edges({}, 0).empty());
}

}  // namespace
}  // namespace fulcrum
