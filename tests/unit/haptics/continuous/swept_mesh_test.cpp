#include "haptics/continuous/swept_mesh.h"

#include "haptics/geometry/shape.h"

#include <catch2/catch.hpp>

#include <vector>

namespace fulcrum {
namespace {

TEST_CASE("swept mesh: every triangle lies in one leaf, and in all boxes above it") {
    const TriangleMesh mesh = make_bumpy_sphere(0.3, 6, 0.1, 6.0).value();
    const auto swept = SweptMesh::create(mesh);
    REQUIRE(swept->n_triangles() == static_cast<std::int32_t>(mesh.triangles().size()));
    std::vector<int> seen(mesh.triangles().size());
    std::vector<std::vector<std::int32_t>> paths{{swept->root()}};
    while (!paths.empty()) {
        const std::vector<std::int32_t> path = paths.back();
        paths.pop_back();
        const std::int32_t child = swept->boxes().first_child(path.back());
        if (child >= 0) {
            for (const std::int32_t next : {child, child + 1}) {
                paths.push_back(path);
                paths.back().push_back(next);
            }
            continue;
        }
        for (const std::int32_t triangle : swept->boxes().triangles_of(path.back())) {
            ++seen[static_cast<std::size_t>(triangle)];
            for (const Vector3& corner : swept->triangle(triangle)) {
                CHECK(corner.norm() <= swept->reach_m());
                for (const std::int32_t node : path) {
                    const OrientedBox& box = swept->boxes().box(node);
                    const Vector3 place = box.to_frame(corner);
                    for (std::size_t i = 0; i < 3; ++i) {
                        REQUIRE(std::abs(place[static_cast<Index>(i)]) <=
                                static_cast<double>(box.half_size[i]));
                    }
                }
            }
        }
    }
    for (const int count : seen) {
        REQUIRE(count == 1);
    }
    CHECK(swept->memory_bytes() > sizeof(Vector3) * mesh.vertices_B().size());
}

}  // namespace
}  // namespace fulcrum
