#include "haptics/collision/triangle_gap.h"

#include "haptics/geometry/triangle_mesh.h"
#include "tests/support/nearest_point.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

TriangleForGap prepare(const Vector3& a, const Vector3& b, const Vector3& c) {
    return prepare_for_gap(
        *touchable(TriangleMesh::build({a, b, c}, {{0, 1, 2}}, {.weld_relative = 0.0})), 0);
}

TEST_CASE("triangle gap: over the face, beside an edge and at a corner it is that of geometry") {
    const TriangleForGap t = prepare({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    const auto check = [&t](const Vector3& point, const Vector3& nearest, TrianglePart part) {
        const TriangleGap gap = find_triangle_gap(t, point);
        CHECK(gap.distance_m == Approx((point - nearest).norm()));
        CHECK((gap.normal_B - (point - nearest).normalized()).norm() < 1e-14);
        CHECK(gap.part == part);
    };
    check({1, 1, 2}, {1, 1, 0}, TrianglePart::face);
    check({1, 1, -3}, {1, 1, 0}, TrianglePart::face);
    check({1, -2, 1}, {1, 0, 0}, TrianglePart::ab);
    check({-2, 3, 1}, {0, 3, 0}, TrianglePart::ac);
    check({3, 3, 1}, {2, 2, 0}, TrianglePart::bc);
    check({-1, -1, 1}, {0, 0, 0}, TrianglePart::corner);
    check({7, 1, 1}, {4, 0, 0}, TrianglePart::corner);
    check({0, 9, 1}, {0, 4, 0}, TrianglePart::corner);
}

TEST_CASE("triangle gap: on the triangle it is zero and the direction the front's") {
    const TriangleForGap t = prepare({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    for (const Vector3& on : {Vector3(1, 1, 0), Vector3(2, 0, 0), Vector3(4, 0, 0)}) {
        const TriangleGap gap = find_triangle_gap(t, on);
        CHECK(gap.distance_m == 0.0);
        CHECK(gap.normal_B == Vector3::UnitZ());
    }
}

TEST_CASE("triangle gap: as the nearest point tells, for triangles of any shape and slivers") {
    Random random(3);
    for (int i = 0; i < 20000; ++i) {
        const Vector3 a = random.in_cube();
        const Vector3 b = random.in_cube();
        Vector3 c = random.in_cube();
        const bool is_sliver = i % 2 == 1;
        if (is_sliver) {
            // Thinner and thinner, to beyond where its plane is known.
            c = a + 0.3 * (b - a) + std::pow(10.0, -1 - i % 12) * random.in_cube();
        }
        const TriangleForGap t = prepare(a, b, c);
        const Vector3 point = 2.0 * random.in_cube();
        const double expected = (point - find_nearest_on_triangle(point, a, b, c)).norm();
        const TriangleGap gap = find_triangle_gap(t, point);
        INFO("triangle " << i);
        REQUIRE(std::abs(gap.distance_m - expected) <= 2.0e-9);
        // All of the triangle lies behind the plane across the direction.
        REQUIRE(gap.normal_B.dot(point) - t.highest_along(gap.normal_B) >=
                gap.distance_m * (1.0 - 1.0e-7) - 1.0e-9);
    }
}

}  // namespace
}  // namespace fulcrum
