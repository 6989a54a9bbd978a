#include "haptics/geometry/height_field.h"
#include "haptics/geometry/mesh_edges.h"
#include "haptics/geometry/mesh_report.h"
#include "haptics/geometry/shape.h"
#include "haptics/geometry/triangle_mesh.h"
#include "haptics/geometry/weld.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/mesh_corners.h"

#include <catch2/catch.hpp>

#include <limits>
#include <map>
#include <random>
#include <utility>

using namespace fulcrum;

namespace {

std::vector<Vector3> corner_points() {
    return {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)};
}
const std::vector<TriangleCorners> kTetrahedron{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

bool mentions(const std::string& sentence, const std::string& word) {
    return sentence.find(word) != std::string::npos;
}

}  // namespace

TEST_CASE("triangle mesh: a good mesh is taken as it is, and the weld can be left out") {
    const auto mesh = TriangleMesh::build(corner_points(), kTetrahedron);
    REQUIRE(mesh);
    CHECK(mesh->triangles() == kTetrahedron);
    CHECK(mesh->vertices_B().size() == 4);
    CHECK(mesh->diagonal_m() == Approx(std::sqrt(3.0)).epsilon(1e-15));
    CHECK(mesh->counts().welded_vertices == 0);
    CHECK(mesh->counts().degenerate_triangles == 0);
    std::vector<Vector3> vertices = corner_points();
    vertices.push_back(vertices[3]);
    std::vector<TriangleCorners> triangles = kTetrahedron;
    triangles[3][2] = 4;
    CHECK(TriangleMesh::build(vertices, triangles)->vertices_B().size() == 4);
    CHECK(TriangleMesh::build(vertices, triangles, {.weld_relative = 0.0})->vertices_B().size() ==
          5);
}

TEST_CASE("triangle mesh: bad input is refused with its place, as is one smaller than 1e-30 m") {
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

TEST_CASE("mesh report: an open plate, an inverted neighbour, an inside-out ball, a third sheet") {
    const MeshReport plate = compute_mesh_report(*make_plate(0.2, 0.1, 4));
    CHECK(plate.open_edges == 16);
    CHECK_FALSE(plate.is_closed());
    CHECK(plate.volume_m3 == 0.0);
    CHECK(mentions(to_sentence(plate), "16 open edges"));

    const auto box = make_box(Vector3::Ones());
    auto triangles = box->triangles();
    std::swap(triangles[5][0], triangles[5][1]);
    const MeshReport mixed =
        compute_mesh_report(*TriangleMesh::build(box->vertices_B(), triangles));
    CHECK(mixed.inconsistent_edges == 3);
    CHECK(mixed.is_closed());
    CHECK(mentions(to_sentence(mixed), "turned over"));

    CHECK(compute_mesh_report(*box).is_sound());
    CHECK_FALSE(plate.is_sound());
    CHECK_FALSE(mixed.is_sound());

    const MeshReport inverted = compute_mesh_report(*make_inverted(*make_sphere(1.0, 3)));
    CHECK(inverted.inside_out);
    CHECK_FALSE(inverted.is_sound());
    CHECK(inverted.inconsistent_edges == 0);
    CHECK(mentions(to_sentence(inverted), "inwards"));

    triangles = box->triangles();
    triangles.push_back({0, 1, 7});
    const MeshReport finned =
        compute_mesh_report(*TriangleMesh::build(box->vertices_B(), triangles));
    CHECK(finned.non_manifold_edges == 2);  // 0-1 and the diagonal 1-7
    CHECK(mentions(to_sentence(finned), "three or more"));
}

TEST_CASE("mesh report: dropped triangles are told") {
    const auto box = make_box(Vector3::Ones());
    auto triangles = box->triangles();
    triangles.push_back({2, 2, 5});
    const MeshReport report =
        compute_mesh_report(*TriangleMesh::build(box->vertices_B(), triangles));
    CHECK(report.degenerate_triangles == 1);
    CHECK_FALSE(report.is_sound());
    CHECK(to_sentence(report) ==
          "The mesh of 12 triangles, 1 x 1 x 1 m, has 1 triangle without area, left out.");
}

TEST_CASE("mesh report: cracks and crossings are told, and far from the origin volume is kept") {
    MeshReport report = compute_mesh_report(*make_box(Vector3::Ones()));
    report.closed_cracks = 2;
    CHECK_FALSE(report.is_sound());
    CHECK(to_sentence(report) ==
          "The mesh of 12 triangles, 1 x 1 x 1 m, has 2 cracks, now closed.");
    report.closed_cracks = 0;
    report.self_intersections = 1;
    CHECK_FALSE(report.is_sound());
    CHECK(mentions(to_sentence(report), "has 1 place where it passes through itself"));
    report.more_self_intersections = true;
    CHECK(mentions(to_sentence(report), "at least 1 place"));
    report.self_intersections = 0;
    CHECK_FALSE(report.is_sound());
    CHECK(mentions(to_sentence(report), "too crowded"));
    auto vertices = make_box(Vector3::Ones())->vertices_B();
    for (Vector3& vertex : vertices) {
        vertex += Vector3(1e5, -2e5, 3e5);
    }
    const auto moved = TriangleMesh::build(vertices, make_box(Vector3::Ones())->triangles());
    CHECK(compute_mesh_report(*moved).volume_m3 == Approx(1.0).epsilon(1e-9));
}

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

TEST_CASE(
    "weld: neighbours across a cell's wall find each other; enormous ones neither weld nor fail") {
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
    const std::vector<Vector3> vertices{Vector3(1e30, 0.0, 0.0), Vector3(-1e30, 0.0, 0.0),
                                        Vector3(1e30, 0.0, 0.0)};
    CHECK(compute_welded_indices(vertices, 1e-300) == std::vector<std::int32_t>{0, 1, 0});
}

TEST_CASE("height field: its corners are the grid's, its front looks up; bad sizes are refused") {
    const auto mesh = make_height_field(
        {.width_m = 2.0, .depth_m = 4.0, .n_x = 3, .n_z = 2, .heights_m = {1, 2, 3, 4, 5, 6}});
    REQUIRE(mesh);
    REQUIRE(mesh->vertices_B().size() == 6);
    CHECK(mesh->vertices_B()[0] == Vector3(-1.0, 1.0, -2.0));
    CHECK(mesh->vertices_B()[1] == Vector3(0.0, 2.0, -2.0));
    CHECK(mesh->vertices_B()[5] == Vector3(1.0, 6.0, 2.0));
    REQUIRE(mesh->triangles().size() == 4);
    for (const TriangleCorners& t : mesh->triangles()) {
        CHECK(front_of(*mesh, t).y() > 0.0);
    }
    CHECK(make_height_field({}));
    CHECK_FALSE(make_height_field({.width_m = 0.0}));
    CHECK_FALSE(make_height_field({.depth_m = -1.0}));
    CHECK_FALSE(make_height_field({.n_x = 1, .heights_m = {0.0, 0.0}}));
    CHECK_FALSE(make_height_field({.n_x = 3}));
    CHECK_FALSE(make_height_field({.heights_m = {0.0, 0.0, 0.0, kNan}}));
}
