#include "haptics/geometry/triangle_mesh.h"

#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <limits>
#include <random>

namespace fulcrum {
namespace {

std::vector<Vector3> corner_points() {
    return {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)};
}
const std::vector<TriangleCorners> kTetrahedron{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

TEST_CASE("triangle mesh: a good mesh is taken as it is") {
    const auto mesh = TriangleMesh::build(corner_points(), kTetrahedron);
    REQUIRE(mesh);
    CHECK(mesh->triangles() == kTetrahedron);
    CHECK(mesh->vertices_B().size() == 4);
    CHECK(mesh->diagonal_m() == Approx(std::sqrt(3.0)).epsilon(1e-15));
    CHECK(mesh->counts().welded_vertices == 0);
    CHECK(mesh->counts().degenerate_triangles == 0);
}

TEST_CASE("triangle mesh: bad input is refused with the place and the number") {
    for (const double bad : {kNan, kInfinity, -kInfinity, 2.0e30}) {
        auto vertices = corner_points();
        vertices[2].y() = bad;
        const auto mesh = TriangleMesh::build(vertices, kTetrahedron, {}, "apple.glb");
        REQUIRE_FALSE(mesh);
        CHECK(mesh.error().where == "apple.glb");
        CHECK(mesh.error().message.find("vertex 2") != std::string::npos);
    }
    for (const std::int32_t bad : {-1, 4, std::numeric_limits<std::int32_t>::max()}) {
        auto triangles = kTetrahedron;
        triangles[3][1] = bad;
        const auto mesh = TriangleMesh::build(corner_points(), triangles);
        REQUIRE_FALSE(mesh);
        CHECK(mesh.error().message.find("triangle 3") != std::string::npos);
    }
    CHECK_FALSE(TriangleMesh::build({}, {}));
    CHECK_FALSE(TriangleMesh::build(corner_points(), {}));
    CHECK_FALSE(TriangleMesh::build(corner_points(), {{0, 0, 1}}));
    for (const double bad : {kNan, -1e-9, 0.02}) {
        CHECK_FALSE(TriangleMesh::build(corner_points(), kTetrahedron, {.weld_relative = bad}));
    }
}

TEST_CASE("triangle mesh: triangles without area are dropped at any scale, thin ones stay") {
    for (const double scale : {1e-9, 1e-4, 1.0, 1e4, 1e20}) {
        std::vector<Vector3> vertices{Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(2, 0, 0),
                                      Vector3(0, 1e-9, 0), Vector3(5, 5, 5)};
        for (Vector3& vertex : vertices) {
            vertex *= scale;
        }
        const auto mesh = TriangleMesh::build(
            vertices, {{0, 1, 2}, {0, 2, 3}, {1, 1, 3}, {0, 1, 4}}, {.weld_relative = 0.0});
        REQUIRE(mesh);
        CHECK(mesh->triangles().size() == 2);
        CHECK(mesh->counts().degenerate_triangles == 2);
    }
}

TEST_CASE("triangle mesh: vertices within the tolerance become one, others stay, at any scale") {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (const double scale : {1e-4, 1.0, 1e4}) {
        // A grid of points 0.1 apart, each given five times, moved by up to 1e-6 of the size.
        std::vector<Vector3> vertices;
        std::vector<TriangleCorners> triangles;
        for (int i = 0; i < 1000; ++i) {
            const Vector3 point(0.1 * (i % 10), 0.1 * (i / 10 % 10), 0.1 * (i / 100));
            for (int copy = 0; copy < 5; ++copy) {
                const Vector3 moved =
                    point + 0.5e-6 * Vector3(unit(random), unit(random), unit(random));
                vertices.emplace_back(scale * moved);
            }
        }
        for (std::int32_t i = 5; i < 5000; i += 5) {
            triangles.push_back({i - 5 + i % 3, i + i % 4, (i + 503) % 5000});
        }
        const auto mesh = TriangleMesh::build(vertices, triangles, {.weld_relative = 2.0e-6});
        REQUIRE(mesh);
        CHECK(mesh->counts().welded_vertices == 4000);
        CHECK(mesh->vertices_B().size() <= 1000);
        for (const TriangleCorners& corners : mesh->triangles()) {
            for (const std::int32_t corner : corners) {
                REQUIRE(corner < static_cast<std::int32_t>(mesh->vertices_B().size()));
            }
        }
    }
}

TEST_CASE("triangle mesh: the weld can be left out") {
    std::vector<Vector3> vertices = corner_points();
    vertices.push_back(vertices[3]);
    std::vector<TriangleCorners> triangles = kTetrahedron;
    triangles[3][2] = 4;
    CHECK(TriangleMesh::build(vertices, triangles)->vertices_B().size() == 4);
    CHECK(TriangleMesh::build(vertices, triangles, {.weld_relative = 0.0})->vertices_B().size() ==
          5);
}

TEST_CASE("triangle mesh: one smaller than 1e-30 m is refused, for its products leave a double") {
    for (const double scale : {1e-29, 1e-30, 5e-31, 1e-32, 1e-100, 1e-160, 1e-300}) {
        std::vector<Vector3> vertices = corner_points();
        for (Vector3& vertex : vertices) {
            vertex *= scale;
        }
        const auto mesh = TriangleMesh::build(vertices, kTetrahedron, {}, "dust.glb");
        CHECK(mesh.has_value() == (scale >= 1e-30));
        if (!mesh) {
            CHECK(mesh.error().where == "dust.glb");
        }
    }
}

}  // namespace
}  // namespace fulcrum
