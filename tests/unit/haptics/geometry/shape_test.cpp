#include "haptics/geometry/shape.h"

#include "haptics/geometry/mesh_report.h"
#include "tests/support/mesh_corners.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

TEST_CASE("shape: all but the plate are closed, consistent and have the volume they should") {
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
    };
    check(make_box(Vector3(0.1, 0.2, 0.3)), 0.006, 1e-12);
    check(make_sphere(0.1, 30), 4.0 / 3.0 * pi * 1e-3, 3e-3);
    check(make_globe(0.1, 120, 60), 4.0 / 3.0 * pi * 1e-3, 3e-3);
    check(make_cylinder(0.1, 0.3, 120), pi * 0.01 * 0.3, 1e-3);
    check(make_capsule(0.1, 0.3, 120, 30), pi * 0.01 * 0.3 + 4.0 / 3.0 * pi * 1e-3, 3e-3);
    check(make_capsule(0.1, 0.3, 4, 1), pi * 0.01 * 0.3 + 4.0 / 3.0 * pi * 1e-3, 0.6);
    check(make_torus(0.1, 0.02, 120, 60), 2.0 * pi * pi * 0.1 * 0.02 * 0.02, 4e-3);
    check(make_bumpy_sphere(2.0, 30, 0.0, 0.0), 4.0 / 3.0 * pi * 8.0, 3e-3);
}

TEST_CASE("shape: boxes lie where they are put, each closed, and are as many as they are") {
    const std::array<PlacedBox, 3> boxes{{{Vector3(0.0, 0.1, 0.0), Vector3(1.0, 0.2, 0.1)},
                                          {Vector3(0.5, 0.1, 0.0), Vector3(0.1, 0.2, 1.0)},
                                          {Vector3(3.0, 0.0, 0.0), Vector3(0.2, 0.2, 0.2)}}};
    const auto mesh = make_boxes(boxes);
    REQUIRE(mesh);
    CHECK(mesh->triangles().size() == 36);
    CHECK(mesh->vertices_B().size() == 24);  // corners that fall together stay apart
    const MeshReport report = compute_mesh_report(*mesh);
    CHECK(report.is_closed());
    CHECK(report.volume_m3 == Approx(0.02 + 0.02 + 0.008).epsilon(1e-12));
    CHECK(mesh->upper_B().isApprox(Vector3(3.1, 0.2, 0.5), 1e-12));
    CHECK(mesh->lower_B().isApprox(Vector3(-0.5, -0.1, -0.5), 1e-12));
    CHECK_FALSE(make_boxes({}));
}

TEST_CASE("shape: the number of triangles is as documented") {
    CHECK(make_box(Vector3::Ones())->triangles().size() == 12);
    const auto sphere = make_sphere(1.0, 7);
    CHECK(sphere->triangles().size() == 20 * 49);
    CHECK(sphere->vertices_B().size() == 10 * 49 + 2);  // Euler: V - E + F = 2, 2 E = 3 F
    CHECK(make_globe(1.0, 8, 4)->triangles().size() == 8 * 2 * 3);
    CHECK(make_cylinder(1.0, 1.0, 8)->triangles().size() == 8 * 4);
    CHECK(make_capsule(1.0, 1.0, 8, 3)->triangles().size() == 8 * 2 * 6);
    CHECK(make_plate(1.0, 1.0, 5)->triangles().size() == 50);
    for (const Vector3& vertex : sphere->vertices_B()) {
        REQUIRE(vertex.norm() == Approx(1.0).epsilon(1e-14));
    }
}

TEST_CASE("shape: sizes and places are as documented") {
    const auto box = make_box(Vector3(0.1, 0.2, 0.3));
    CHECK((box->upper_B() - Vector3(0.05, 0.1, 0.15)).norm() < 1e-16);
    CHECK((box->lower_B() + Vector3(0.05, 0.1, 0.15)).norm() < 1e-16);
    const auto plate = make_plate(0.4, 0.2, 3);
    CHECK((plate->upper_B() - Vector3(0.2, 0.0, 0.1)).norm() < 1e-16);
    const auto torus = make_torus(0.3, 0.1, 16, 8);
    CHECK((torus->upper_B() - Vector3(0.4, 0.1, 0.4)).norm() < 1e-15);
    for (const Vector3& vertex : torus->vertices_B()) {
        const double from_ring = std::hypot(std::hypot(vertex.x(), vertex.z()) - 0.3, vertex.y());
        REQUIRE(from_ring == Approx(0.1).epsilon(1e-12));
    }
    const auto cylinder = make_cylinder(0.1, 0.4, 8);
    CHECK((cylinder->upper_B() - Vector3(0.1, 0.2, 0.1)).norm() < 1e-15);
    const auto capsule = make_capsule(0.1, 0.4, 8, 3);
    CHECK((capsule->upper_B() - Vector3(0.1, 0.3, 0.1)).norm() < 1e-15);
    CHECK((capsule->lower_B() + Vector3(0.1, 0.3, 0.1)).norm() < 1e-15);
    for (const Vector3& vertex : capsule->vertices_B()) {
        const double along = std::max(std::abs(vertex.y()) - 0.2, 0.0);
        REQUIRE(std::hypot(std::hypot(vertex.x(), vertex.z()), along) ==
                Approx(0.1).epsilon(1e-12));
    }
    const auto globe = make_globe(0.7, 9, 5);
    for (const Vector3& vertex : globe->vertices_B()) {
        REQUIRE(vertex.norm() == Approx(0.7).epsilon(1e-14));
    }
    const auto bumpy = make_bumpy_sphere(2.0, 6, 0.2, 7.0);
    for (const Vector3& vertex : bumpy->vertices_B()) {
        const Vector3 u = vertex.normalized();
        const double wave =
            (std::sin(7.0 * u.x()) + std::sin(7.0 * u.y()) + std::sin(7.0 * u.z())) / 3.0;
        REQUIRE(vertex.norm() == Approx(2.0 * (1.0 + 0.2 * wave)).epsilon(1e-9));
    }
}

TEST_CASE("shape: fronts look outwards, those of the plate up, and inverted ones the other way") {
    const auto plate = make_plate(1.0, 1.0, 2);
    const auto sphere = make_sphere(1.0, 4);
    const auto inverted = make_inverted(*sphere);
    for (const TriangleCorners& t : plate->triangles()) {
        REQUIRE(front_of(*plate, t).y() > 0.0);
    }
    for (std::size_t i = 0; i < sphere->triangles().size(); ++i) {
        const TriangleCorners& t = sphere->triangles()[i];
        const Vector3 corner = corners_of(*sphere, t)[0];
        REQUIRE(front_of(*sphere, t).dot(corner) > 0.0);
        REQUIRE(front_of(*inverted, inverted->triangles()[i]).dot(corner) < 0.0);
    }
}

TEST_CASE("shape: measures out of range are refused") {
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
