#include "haptics/voxel/triangle_clusters.h"

#include "haptics/geometry/shape.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

constexpr double kRounding_m = 1.0e-12;

double find_by_brute_force(const TriangleMesh& mesh, const Vector3& p) {
    double least = HUGE_VAL;
    for (const TriangleCorners& t : mesh.triangles()) {
        const auto at = [&](std::size_t i) {
            return mesh.vertices_B()[static_cast<std::size_t>(t[i])];
        };
        least = std::min(least, compute_square_distance(p, {at(0), at(1), at(2)}));
    }
    return std::sqrt(least);
}

}  // namespace

TEST_CASE(
    "triangle clusters: a triangle's distance above its face, beyond its edges and its corners") {
    const TriangleAt t{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}};
    CHECK(compute_square_distance({0.5, 0.5, -0.7}, t) == Approx(0.49));
    CHECK(compute_square_distance({1.0, -3.0, 4.0}, t) == Approx(25.0));
    CHECK(compute_square_distance({2.0, 2.0, 0.0}, t) == Approx(2.0));
    CHECK(compute_square_distance({-1.0, -2.0, 2.0}, t) == Approx(9.0));
    CHECK(compute_square_distance({5.0, 0.0, 4.0}, t) == Approx(25.0));
}

TEST_CASE(
    "triangle clusters: a triangle without area is its longest edge, without length a point") {
    const TriangleAt line{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {3.0, 0.0, 0.0}};
    CHECK(compute_square_distance({2.0, 0.5, 0.0}, line) == Approx(0.25));
    const TriangleAt point{Vector3::UnitX(), Vector3::UnitX(), Vector3::UnitX()};
    CHECK(compute_square_distance({1.0, 0.0, 2.0}, point) == Approx(4.0));
}

TEST_CASE(
    "triangle clusters: the nearest triangle is brute force's, near, far, inside and bounded") {
    const TriangleMesh mesh = *make_bumpy_sphere(1.0, 9, 0.1, 8.0);
    const TriangleClusters clusters(mesh);
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        const Vector3 p = random.direction() * (3.0 * random.uniform());
        const double exact = find_by_brute_force(mesh, p);
        CHECK(clusters.find_distance(p) == Approx(exact).margin(kRounding_m));
        CHECK(clusters.find_distance(p, 0.5 * exact) == 0.5 * exact);
        CHECK(clusters.find_distance(p, 2.0 * exact + 0.1) == Approx(exact).margin(kRounding_m));
    }
}

TEST_CASE(
    "triangle clusters: one triangle is a tree as well, and a far cluster's area vector is the "
    "sum") {
    const std::vector<Vector3> vertices{Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY()};
    const TriangleClusters one(TriangleMesh::build(vertices, {{0, 1, 2}}).value());
    CHECK(one.find_distance({0.2, 0.2, 3.0}) == Approx(3.0));

    const TriangleClusters ball(*make_sphere(1.0, 10));
    int n_clusters = 0;
    ball.for_each_near(
        [&](const TriangleCluster& whole) noexcept {
            ++n_clusters;
            CHECK(whole.area_vector_B.norm() < 1.0e-12);  // closed
            CHECK(whole.radius_m >= 1.0);
            return true;
        },
        [](const TriangleAt&) noexcept {});
    CHECK(n_clusters == 1);
}
