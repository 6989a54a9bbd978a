#include "haptics/geometry/mesh_report.h"

#include "haptics/geometry/shape.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

bool mentions(const std::string& sentence, const std::string& word) {
    return sentence.find(word) != std::string::npos;
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

TEST_CASE("mesh report: closed cracks and places where it passes through itself are told") {
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
}

TEST_CASE("mesh report: a mesh far from its origin keeps its volume") {
    auto vertices = make_box(Vector3::Ones())->vertices_B();
    for (Vector3& vertex : vertices) {
        vertex += Vector3(1e5, -2e5, 3e5);
    }
    const auto moved = TriangleMesh::build(vertices, make_box(Vector3::Ones())->triangles());
    CHECK(compute_mesh_report(*moved).volume_m3 == Approx(1.0).epsilon(1e-9));
}

}  // namespace
}  // namespace fulcrum
