#include "haptics/geometry/convex_hull.h"
#include "haptics/geometry/mesh_report.h"
#include "haptics/geometry/shape.h"
#include "haptics/geometry/solid_moments.h"
#include "haptics/math/orientation.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/mesh_corners.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>

using namespace fulcrum;

namespace {

constexpr double kRounding = 1.0e-13;

// Closed, and no point in front of any face, by exact signs.
TriangleMesh check_hull(const std::vector<Vector3>& points) {
    const auto hull = make_convex_hull(points);
    REQUIRE(hull);
    CHECK(compute_mesh_report(*hull).is_closed());
    for (const TriangleCorners& t : hull->triangles()) {
        const auto [a, b, c] = corners_of(*hull, t);
        for (const Vector3& point : points) {
            REQUIRE(orientation(a, b, c, point) <= 0);
        }
    }
    // Euler, for a body without holes.
    CHECK(hull->triangles().size() == 2 * hull->vertices_B().size() - 4);
    return *hull;
}

TriangleMesh make_placed(const TriangleMesh& mesh, const Pose& X_WB, double scale) {
    return test::move_corners(mesh, [&](const Vector3& v) { return Vector3(scale * (X_WB * v)); },
                              {.weld_relative = 0.0});
}

}  // namespace

TEST_CASE("shape: closed, consistent, with volume and number of triangles as documented") {
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

TEST_CASE("shape: a cup is closed, its fronts look out, and it holds what its cones do") {
    constexpr int kSides = 24;
    const auto cup = make_cup(0.1, 0.07, 0.14, 0.01, kSides);
    REQUIRE(cup);
    CHECK(cup->triangles().size() == 8 * kSides);
    const MeshReport report = compute_mesh_report(*cup);
    CHECK(report.is_closed());
    CHECK(report.inconsistent_edges == 0);
    CHECK_FALSE(report.inside_out);
    // Of cones whose sides touch circles from outside.
    const auto frustum_m3 = [](double height_m, double a_m, double b_m) {
        return kSides * std::tan(std::numbers::pi / kSides) * height_m / 3.0 *
               (a_m * a_m + a_m * b_m + b_m * b_m);
    };
    CHECK(report.volume_m3 ==
          Approx(frustum_m3(0.15, 0.11, 0.08) - frustum_m3(0.14, 0.1, 0.07)).epsilon(1e-12));
    CHECK(cup->upper_B().y() == 0.0);
    CHECK(cup->lower_B().y() == Approx(-0.15));
    CHECK_FALSE(make_cup(0.1, 0.07, 0.0, 0.01, kSides));
    CHECK_FALSE(make_cup(0.1, 0.07, 0.14, 0.01, 2));
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

TEST_CASE("convex hull: of a cube's grid, whatever lies in planes, it has eight corners") {
    std::vector<Vector3> points;
    for (int i = 0; i < 343; ++i) {
        points.emplace_back(0.1 * (i % 7), 0.3 * (i / 7 % 7), 0.7 * (i / 49));
    }
    points.insert(points.end(), points.begin(), points.begin() + 200);  // twice
    const TriangleMesh hull = check_hull(points);
    CHECK(hull.lower_B() == Vector3::Zero());
    CHECK(hull.upper_B().isApprox(Vector3(0.6, 1.8, 4.2)));
    // Rounding puts some points a rounding in front of the cube's planes; without it there are 8.
    CHECK(hull.vertices_B().size() >= 8);
    points = std::vector<Vector3>();
    for (int i = 0; i < 125; ++i) {
        points.emplace_back(i % 5, i / 5 % 5, i / 25);
    }
    CHECK(check_hull(points).vertices_B().size() == 8);
}

TEST_CASE("convex hull: clouds, balls and rings anywhere; what has no thickness is refused") {
    Random random(12);
    for (const double scale : {1e-4, 1.0, 1e3}) {
        std::vector<Vector3> cloud;
        std::vector<Vector3> ball;
        std::vector<Vector3> coin;
        for (int i = 0; i < 400; ++i) {
            cloud.emplace_back(scale * random.vector());
            ball.emplace_back(scale * (random.direction() + Vector3(100.0, -50.0, 20.0)));
            const Vector3 u = random.direction();
            coin.emplace_back(scale * Vector3(u.x(), 1e-9 * u.y(), u.z()));
        }
        check_hull(cloud);
        CHECK(check_hull(ball).vertices_B().size() == 400);
        check_hull(coin);
    }
    CHECK_FALSE(make_convex_hull({}));
    CHECK_FALSE(make_convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    CHECK_FALSE(make_convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {3, 7, 0}}));
    CHECK_FALSE(make_convex_hull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}));
    CHECK_FALSE(make_convex_hull({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}));
    CHECK_FALSE(make_convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {kNan, 0, 0}}));
    CHECK(make_convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})->triangles().size() == 4);
}

TEST_CASE("solid moments: of a box, to rounding, and of a tetrahedron anywhere") {
    const Vector3 size(0.3, 0.2, 0.1);
    const SolidMoments box = compute_solid_moments(*make_box(size));
    CHECK(box.volume_m3 == Approx(size.prod()).epsilon(kRounding));
    CHECK(box.centre_B.norm() < kRounding);
    const Matrix3 of_box = (size.prod() / 12.0 * size.cwiseAbs2()).asDiagonal();
    CHECK((box.second_m5 - of_box).norm() < kRounding * of_box.norm());
    const Vector3 inertia = compute_unit_inertia(box).diagonal();
    CHECK(inertia.x() == Approx(size.prod() / 12.0 * (0.04 + 0.01)).epsilon(kRounding));
    CHECK(inertia.y() == Approx(size.prod() / 12.0 * (0.09 + 0.01)).epsilon(kRounding));
    Random random(3);
    for (int i = 0; i < 50; ++i) {
        std::vector<Vector3> corners;
        for (int j = 0; j < 4; ++j) {
            corners.push_back(random.vector() + Vector3(5.0, -3.0, 2.0));
        }
        const SolidMoments moments = compute_solid_moments(*make_convex_hull(corners));
        Matrix3 edges;
        edges << corners[1] - corners[0], corners[2] - corners[0], corners[3] - corners[0];
        const double volume = std::abs(edges.determinant()) / 6.0;
        const Vector3 centre = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
        // Of a simplex: V / 20 of the sum over corners of (p - c)(p - c)^T.
        Matrix3 second = Matrix3::Zero();
        for (const Vector3& corner : corners) {
            second += volume / 20.0 * (corner - centre) * (corner - centre).transpose();
        }
        CHECK(moments.volume_m3 == Approx(volume).epsilon(1.0e-10));
        CHECK((moments.centre_B - centre).norm() < 1.0e-10);
        CHECK((moments.second_m5 - second).norm() < 1.0e-10 * second.norm());
    }
}

TEST_CASE("solid moments: of a cylinder of n sides in closed form, and the round one's limit") {
    for (const int n : {3, 8, 64, 512}) {
        const double radius = 0.05;
        const double length = 0.4;
        std::vector<Vector2> corners;
        for (int i = 0; i < n; ++i) {
            const double turn = 2.0 * std::numbers::pi * i / n;
            corners.emplace_back(radius * std::cos(turn), radius * std::sin(turn));
        }
        const SolidMoments moments = compute_solid_moments(*make_prism(corners, length));
        // n triangles of the angle t at the axis: A = n r^2 sin(t) / 2, polar moment A r^2 (2 + cos t) / 6.
        const double t = 2.0 * std::numbers::pi / n;
        const double area = 0.5 * n * radius * radius * std::sin(t);
        const double polar = area * radius * radius * (2.0 + std::cos(t)) / 6.0;
        CHECK(moments.volume_m3 == Approx(area * length).epsilon(1.0e-12));
        const Vector3 inertia = compute_unit_inertia(moments).diagonal();
        CHECK(inertia.z() == Approx(length * polar).epsilon(1.0e-12));
        CHECK(inertia.x() ==
              Approx(0.5 * length * polar + area * std::pow(length, 3) / 12.0).epsilon(1.0e-12));
        // m r^2 / 2 in the limit, from below by about pi^2 n^-2 (4/3 + 2/3).
        const double round = 0.5 * std::numbers::pi * std::pow(radius, 4) * length;
        CHECK(inertia.z() < round);
        CHECK(inertia.z() > round * (1.0 - 4.0 * std::pow(std::numbers::pi / n, 2)));
    }
}

TEST_CASE("solid moments: of a ball, with an error of second order in its triangles") {
    const double volume = 4.0 / 3.0 * std::numbers::pi;
    double last = 1.0;
    for (const int frequency : {4, 8, 16, 32}) {
        const SolidMoments ball = compute_solid_moments(*make_sphere(1.0, frequency));
        const double inertia = compute_unit_inertia(ball)(1, 1);
        const double error = 1.0 - inertia / (0.4 * volume);
        CHECK(error > 0.0);
        if (frequency > 4) {
            CHECK(last / error == Approx(4.0).epsilon(0.1));
        }
        last = error;
    }
    CHECK(last < 5.0e-3);
}

TEST_CASE("solid moments: shifts and turns leave them as they are, sizes scale them by powers") {
    const TriangleMesh mesh = *make_bumpy_sphere(0.1, 6, 0.4, 3.0);
    const SolidMoments plain = compute_solid_moments(mesh);
    Random random(8);
    for (int i = 0; i < 20; ++i) {
        const Pose X_WB{random.vector(), random.turn(3.0)};
        const double scale = std::exp(3.0 * random.uniform());
        const SolidMoments moved = compute_solid_moments(make_placed(mesh, X_WB, scale));
        const Matrix3 R = X_WB.orientation.toRotationMatrix();
        const Matrix3 turned = std::pow(scale, 5) * R * plain.second_m5 * R.transpose();
        CHECK(moved.volume_m3 == Approx(std::pow(scale, 3) * plain.volume_m3).epsilon(1.0e-12));
        CHECK((moved.centre_B - scale * (X_WB * plain.centre_B)).norm() < 1.0e-13 * scale * 10.0);
        CHECK((moved.second_m5 - turned).norm() < 1.0e-11 * turned.norm());
    }
    // A power of 2 changes no digit.
    const SolidMoments doubled = compute_solid_moments(make_placed(mesh, Pose{}, 2.0));
    CHECK(doubled.second_m5 == 32.0 * plain.second_m5);
}

TEST_CASE("solid moments: smallest and largest meshes, and one turned over") {
    for (const double size : {1.0e-14, 1.0e14}) {
        const SolidMoments box = compute_solid_moments(*make_box(size * Vector3::Ones()));
        CHECK(box.volume_m3 == Approx(std::pow(size, 3)).epsilon(1.0e-12));
        CHECK(box.second_m5(2, 2) == Approx(std::pow(size, 5) / 12.0).epsilon(1.0e-12));
    }
    const TriangleMesh box = *make_box(Vector3(1.0, 2.0, 3.0));
    const SolidMoments inverted = compute_solid_moments(*make_inverted(box));
    CHECK(inverted.volume_m3 == Approx(-6.0));
    CHECK(inverted.second_m5.isApprox(-compute_solid_moments(box).second_m5));
    const SolidMoments plate = compute_solid_moments(*make_plate(1.0, 1.0, 3));
    CHECK(plate.volume_m3 == 0.0);
    CHECK(plate.centre_B == Vector3::Zero());
}

TEST_CASE("principal axes: give back the tensor, by a rotation, moments ascending") {
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const Vector3 moments = random.in_cube().cwiseAbs() + Vector3(1.0, 1.0, 1.0);
        const Matrix3 R = random.turn(3.0).toRotationMatrix();
        const Matrix3 tensor = R * moments.asDiagonal() * R.transpose();
        const PrincipalAxes axes = compute_principal_axes(tensor);
        const Matrix3 back = axes.orientation.toRotationMatrix();
        CHECK((back * axes.moments.asDiagonal() * back.transpose() - tensor).norm() < 1.0e-9);
        CHECK(back.determinant() == Approx(1.0).epsilon(1.0e-12));
        CHECK(axes.moments.x() <= axes.moments.y());
        CHECK(axes.moments.y() <= axes.moments.z());
        CHECK(back.col(0).maxCoeff() >= -back.col(0).minCoeff());
        CHECK(back.col(1).maxCoeff() >= -back.col(1).minCoeff());
        CHECK(axes.orientation.coeffs() == compute_principal_axes(tensor).orientation.coeffs());
    }
}

TEST_CASE("principal axes: equal moments keep the tensor's own axes, rounding beside them or not") {
    Matrix3 tensor = 2.0 * Matrix3::Identity();
    tensor(0, 1) = tensor(1, 0) = 1.0e-12;
    const PrincipalAxes ball = compute_principal_axes(tensor);
    CHECK(ball.orientation.isApprox(Quaternion::Identity()));
    CHECK(ball.moments.isApprox(Vector3::Constant(2.0)));
    // A long cylinder along z.
    const PrincipalAxes rod = compute_principal_axes(Vector3(5.0, 5.0, 1.0).asDiagonal());
    CHECK(rod.moments == Vector3(1.0, 5.0, 5.0));
    CHECK((rod.orientation * Vector3::UnitX()).isApprox(Vector3::UnitZ()));
    // Nothing, and no number: no axes are sought, and nothing is hidden.
    CHECK(compute_principal_axes(Matrix3::Zero()).moments == Vector3::Zero());
    CHECK_FALSE(compute_principal_axes(Matrix3::Constant(kNan)).moments.allFinite());
}
