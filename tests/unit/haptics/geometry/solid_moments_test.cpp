#include "haptics/geometry/solid_moments.h"

#include "haptics/geometry/convex_hull.h"
#include "haptics/geometry/shape.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

// Sums over some hundred triangles, in terms of the solid's own size.
constexpr double kRounding = 1.0e-13;

TriangleMesh make_placed(const TriangleMesh& mesh, const Pose& X_WB, double scale) {
    std::vector<Vector3> vertices = mesh.vertices_B();
    for (Vector3& vertex : vertices) {
        vertex = scale * (X_WB * vertex);
    }
    return *TriangleMesh::build(std::move(vertices), mesh.triangles(), {.weld_relative = 0.0});
}

TEST_CASE("solid moments: of a box, to rounding") {
    const Vector3 size(0.3, 0.2, 0.1);
    const SolidMoments box = compute_solid_moments(*make_box(size));
    CHECK(box.volume_m3 == Approx(size.prod()).epsilon(kRounding));
    CHECK(box.centre_B.norm() < kRounding);
    const Matrix3 second = (size.prod() / 12.0 * size.cwiseAbs2()).asDiagonal();
    CHECK((box.second_m5 - second).norm() < kRounding * second.norm());
    const Vector3 inertia = compute_unit_inertia(box).diagonal();
    CHECK(inertia.x() == Approx(size.prod() / 12.0 * (0.04 + 0.01)).epsilon(kRounding));
    CHECK(inertia.y() == Approx(size.prod() / 12.0 * (0.09 + 0.01)).epsilon(kRounding));
}

TEST_CASE("solid moments: of a tetrahedron anywhere, by its corners' covariance") {
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

}  // namespace
}  // namespace fulcrum
