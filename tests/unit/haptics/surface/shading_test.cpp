#include "haptics/surface/shading.h"

#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <rapidcheck.h>

using namespace fulcrum;

namespace {

double angle_deg(const Vector3& a, const Vector3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::numbers::pi;
}

struct Face {
    std::array<Vector3, 3> p;
    Vector3 normal;
    Face(const CollisionMesh& mesh, std::int32_t t) {
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = mesh.vertex_B(mesh.corners(t)[i]);
        }
        normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    }
    [[nodiscard]] Vector3 at(double a, double b) const {
        return p[0] + a * (p[1] - p[0]) + b * (p[2] - p[0]);
    }
};

// The worst error against a sphere's own normals, of the faces' normals and of the shaded ones.
std::pair<double, double> sphere_errors_deg(int frequency) {
    const auto mesh = touchable(make_sphere(0.05, frequency));
    const ShadedNormals shaded(mesh, 60.0);
    double flat = 0.0;
    double smooth = 0.0;
    for (std::int32_t t = 0; t < mesh->n_triangles(); ++t) {
        const Face face(*mesh, t);
        for (const auto& [a, b] :
             {std::pair{0.0, 0.0}, {0.5, 0.0}, {1.0 / 3.0, 1.0 / 3.0}, {0.1, 0.8}}) {
            const Vector3 p = face.at(a, b);
            flat = std::max(flat, angle_deg(face.normal, p));
            smooth = std::max(smooth, angle_deg(shaded.normal_B(t, p, face.normal), p));
        }
    }
    return {flat, smooth};
}

}  // namespace

TEST_CASE(
    "shading: errors fall with the faces' size squared; corners and middles are as they are") {
    const auto [flat_8, smooth_8] = sphere_errors_deg(8);
    const auto [flat_16, smooth_16] = sphere_errors_deg(16);
    CHECK(flat_8 > 5.0);
    CHECK(flat_16 == Approx(0.5 * flat_8).epsilon(0.05));
    CHECK(smooth_8 < 0.06 * flat_8);
    CHECK(smooth_16 == Approx(0.25 * smooth_8).epsilon(0.15));
    const auto mesh = touchable(make_sphere(0.05, 3));
    const ShadedNormals shaded(mesh, 60.0);
    for (std::int32_t t = 0; t < mesh->n_triangles(); ++t) {
        const Face face(*mesh, t);
        Vector3 sum = Vector3::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(
                (shaded.normal_B(t, face.p[i], face.normal) - shaded.corner_normal_B(t, i)).norm() <
                1.0e-12);
            sum += shaded.corner_normal_B(t, i);
        }
        const Vector3 middle = shaded.normal_B(t, face.at(1.0 / 3.0, 1.0 / 3.0), face.normal);
        CHECK((middle - sum.normalized()).norm() < 1.0e-12);
    }
}

TEST_CASE("shading: weights are the areas of the opposite triangles") {
    const auto mesh = touchable(make_sphere(0.05, 2));
    const ShadedNormals shaded(mesh, 60.0);
    const Face face(*mesh, 0);
    const Vector3 p = face.at(0.2, 0.3);
    const Vector3 expected =
        (0.5 * shaded.corner_normal_B(0, 0) + 0.2 * shaded.corner_normal_B(0, 1) +
         0.3 * shaded.corner_normal_B(0, 2))
            .normalized();
    CHECK((shaded.normal_B(0, p, face.normal) - expected).norm() < 1.0e-12);
}

TEST_CASE("shading: the direction is continuous across every edge that is smooth") {
    const auto mesh = touchable(make_bumpy_sphere(0.05, 6, 0.05, 9.0));
    const ShadedNormals shaded(mesh, 80.0);
    // Each side's middle, seen from its two triangles.
    for (std::int32_t t = 0; t < mesh->n_triangles(); ++t) {
        for (std::int32_t u = 0; u < t; ++u) {
            int shared = 0;
            Vector3 middle = Vector3::Zero();
            for (const std::int32_t a : mesh->corners(t)) {
                for (const std::int32_t b : mesh->corners(u)) {
                    if (a == b) {
                        ++shared;
                        middle += 0.5 * mesh->vertex_B(a);
                    }
                }
            }
            if (shared == 2) {
                const Vector3 n_t = shaded.normal_B(t, middle, Face(*mesh, t).normal);
                const Vector3 n_u = shaded.normal_B(u, middle, Face(*mesh, u).normal);
                CHECK((n_t - n_u).norm() < 1.0e-12);
            }
        }
    }
}

TEST_CASE("shading: a box keeps its edges below the crease angle, and loses them above") {
    const auto mesh = touchable(make_box(Vector3(0.1, 0.1, 0.1)));
    const ShadedNormals sharp(mesh, 89.0);
    const ShadedNormals round(mesh, 90.0);
    for (std::int32_t t = 0; t < mesh->n_triangles(); ++t) {
        const Face face(*mesh, t);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK((sharp.corner_normal_B(t, i) - face.normal).norm() < 1.0e-12);
            CHECK((round.corner_normal_B(t, i) - face.p[i].normalized()).norm() < 1.0e-12);
        }
    }
}

TEST_CASE("shading: it is on the proxy's side, and a point beside gets its nearest weights") {
    const auto mesh = touchable(make_sphere(0.05, 2));
    const ShadedNormals shaded(mesh, 60.0);
    const Face face(*mesh, 3);
    const Vector3 p = face.at(0.2, 0.3);
    CHECK((shaded.normal_B(3, p, -face.normal) + shaded.normal_B(3, p, face.normal)).norm() <
          1e-15);
    // A hair above it the same; far beside it still a unit vector between those of two corners.
    CHECK((shaded.normal_B(3, p + 1.0e-9 * face.normal, face.normal) -
           shaded.normal_B(3, p, face.normal))
              .norm() < 1.0e-6);
    const Vector3 beside = face.at(0.5, -3.0);
    CHECK(shaded.normal_B(3, beside, face.normal).norm() == Approx(1.0));
    CHECK(angle_deg(shaded.normal_B(3, beside, face.normal), face.normal) < 45.0);
}

TEST_CASE("shading: open edges, edges of three triangles and turned triangles stay sharp") {
    // A fin on a ridge: three triangles share an edge.
    const auto fin =
        TriangleMesh::build({{0, 0, 0}, {0, 0, 1}, {1, 0.1, 0}, {-1, 0.1, 0}, {0, 1, 0}},
                            {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    const auto mesh = touchable(fin);
    const ShadedNormals shaded(mesh, 180.0);
    for (std::int32_t t = 0; t < mesh->n_triangles(); ++t) {
        const Face face(*mesh, t);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK((shaded.corner_normal_B(t, i) - face.normal).norm() < 1.0e-12);
        }
    }
    // Two triangles of a flat square, one of them wound the other way.
    const auto turned = touchable(
        TriangleMesh::build({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}}));
    const ShadedNormals two(turned, 180.0);
    for (std::int32_t t = 0; t < 2; ++t) {
        CHECK((two.corner_normal_B(t, 0) - Face(*turned, t).normal).norm() < 1.0e-12);
    }
    CHECK(two.memory_bytes() > 0);
}
