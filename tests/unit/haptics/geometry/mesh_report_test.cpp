#include "haptics/geometry/mesh_report.h"

#include "haptics/geometry/shape.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace fulcrum {
namespace {

bool mentions(const std::string& sentence, const std::string& word) {
    return sentence.find(word) != std::string::npos;
}

TEST_CASE("mesh report: made shapes are closed, consistent and have the volume they should") {
    const double pi = std::numbers::pi;
    // Facets lie inside the curved surface: the volume falls short by the square of the edge's
    // angle.
    const auto check = [](const Expected<TriangleMesh>& mesh, double volume_m3, double shortfall) {
        REQUIRE(mesh);
        const MeshReport report = compute_mesh_report(*mesh);
        CHECK(report.is_closed());
        CHECK(report.inconsistent_edges == 0);
        CHECK_FALSE(report.inside_out);
        CHECK(report.volume_m3 <= volume_m3 * (1.0 + 1e-12));
        CHECK(report.volume_m3 >= volume_m3 * (1.0 - shortfall));
        CHECK(mentions(to_sentence(report), "needs no mending"));
    };
    check(make_box(Vector3(0.1, 0.2, 0.3)), 0.006, 1e-12);
    check(make_sphere(0.1, 30), 4.0 / 3.0 * pi * 1e-3, 3e-3);
    check(make_globe(0.1, 120, 60), 4.0 / 3.0 * pi * 1e-3, 3e-3);
    check(make_torus(0.1, 0.02, 120, 60), 2.0 * pi * pi * 0.1 * 0.02 * 0.02, 4e-3);
    check(make_bumpy_sphere(2.0, 30, 0.0, 0.0), 4.0 / 3.0 * pi * 8.0, 3e-3);
}

TEST_CASE("mesh report: counts of the made shapes") {
    CHECK(make_box(Vector3::Ones())->triangles().size() == 12);
    const auto sphere = make_sphere(1.0, 7);
    CHECK(sphere->triangles().size() == 20 * 49);
    CHECK(sphere->vertices_B().size() == 10 * 49 + 2);  // Euler: V - E + F = 2, 2 E = 3 F
    CHECK(make_globe(1.0, 8, 4)->triangles().size() == 8 * 2 * 3);
    CHECK(make_plate(1.0, 1.0, 5)->triangles().size() == 50);
    for (const Vector3& vertex : sphere->vertices_B()) {
        REQUIRE(vertex.norm() == Approx(1.0).epsilon(1e-14));
    }
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

    const MeshReport inverted = compute_mesh_report(*make_inverted(*make_sphere(1.0, 3)));
    CHECK(inverted.inside_out);
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
    CHECK(to_sentence(report) ==
          "The mesh of 12 triangles, 1 x 1 x 1 m, has 1 triangle without area, left out.");
}

TEST_CASE("mesh report: a mesh far from its origin keeps its volume") {
    auto vertices = make_box(Vector3::Ones())->vertices_B();
    for (Vector3& vertex : vertices) {
        vertex += Vector3(1e5, -2e5, 3e5);
    }
    const auto moved = TriangleMesh::build(vertices, make_box(Vector3::Ones())->triangles());
    CHECK(compute_mesh_report(*moved).volume_m3 == Approx(1.0).epsilon(1e-9));
}

TEST_CASE("mesh report: shapes out of range are refused") {
    const double nan = std::nan("");
    CHECK_FALSE(make_box(Vector3(1.0, 0.0, 1.0)));
    CHECK_FALSE(make_box(Vector3(1.0, nan, 1.0)));
    CHECK_FALSE(make_sphere(-1.0, 3));
    CHECK_FALSE(make_sphere(1.0, 0));
    CHECK_FALSE(make_sphere(1.0, 513));
    CHECK_FALSE(make_globe(1.0, 2, 5));
    CHECK_FALSE(make_plate(1.0, 1.0, 0));
    CHECK_FALSE(make_bumpy_sphere(1.0, 3, 0.6, 5.0));
    CHECK_FALSE(make_bumpy_sphere(1.0, 3, 0.1, nan));
    CHECK_FALSE(make_torus(0.1, 0.1, 8, 8));
}

}  // namespace
}  // namespace fulcrum
