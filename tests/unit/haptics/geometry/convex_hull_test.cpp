#include "haptics/geometry/convex_hull.h"

#include "haptics/geometry/mesh_report.h"
#include "haptics/math/orientation.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/mesh_corners.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

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

TEST_CASE("convex hull: a grid of points in a cube gives the cube, whatever lies in planes") {
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
}

TEST_CASE("convex hull: on whole numbers a cube has eight corners") {
    std::vector<Vector3> points;
    for (int i = 0; i < 125; ++i) {
        points.emplace_back(i % 5, i / 5 % 5, i / 25);
    }
    CHECK(check_hull(points).vertices_B().size() == 8);
}

TEST_CASE("convex hull: of clouds, balls and flat rings, far from the origin and of any size") {
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
}

TEST_CASE("convex hull: a cloud without thickness, too few points and NaN are refused") {
    CHECK_FALSE(make_convex_hull({}));
    CHECK_FALSE(make_convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    CHECK_FALSE(make_convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {3, 7, 0}}));
    CHECK_FALSE(make_convex_hull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}));
    CHECK_FALSE(make_convex_hull({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}));
    CHECK_FALSE(make_convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {kNan, 0, 0}}));
    CHECK(make_convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})->triangles().size() == 4);
}

}  // namespace
}  // namespace fulcrum
