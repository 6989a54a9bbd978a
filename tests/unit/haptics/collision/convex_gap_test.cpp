#include "haptics/collision/convex_gap.h"

#include "haptics/collision/shape_gap.h"
#include "tests/support/nearest_point.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {
namespace {

using Kind = ConvexCore::Kind;

// A point against a core.
ConvexGap find_point_gap(const ConvexCore& core, const Vector3& p) {
    return find_convex_gap(
        p, [&](const Vector3& direction) { return Vector3(p - core.find_support(-direction)); });
}

template <class Shape>
void compare(const ConvexCore& core, const Shape& shape, unsigned seed) {
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const Vector3 p = std::pow(10.0, (i % 5) - 2) * random.in_cube() + 0.3 * random.direction();
        const Gap exact = find_gap(shape, p);
        const ConvexGap found = find_point_gap(core, p);
        CAPTURE(p);
        if (exact.gap_m > 1.0e-6) {
            REQUIRE(found.gap_m == Approx(exact.gap_m).epsilon(1.0e-8));
            REQUIRE(found.gap_m <= exact.gap_m * (1.0 + 1.0e-14));
            REQUIRE((found.normal - exact.normal_B).norm() <= 3.0e-5);
        } else if (exact.gap_m < -1.0e-6) {
            REQUIRE(found.gap_m == 0.0);
        }
    }
}

TEST_CASE("convex gap: a point's distance from box, cylinder and segment is that in closed form") {
    compare({.kind = Kind::box, .half_m = {1.0, 0.5, 0.2}}, BoxShape{{1.0, 0.5, 0.2}}, 1);
    compare({.kind = Kind::cylinder, .half_m = {0.7, 0.5, 0.0}}, CylinderShape{0.7, 0.5}, 2);
    compare({.kind = Kind::segment, .half_m = {0.0, 1.0, 0.0}}, CapsuleShape{0.0, 1.0}, 3);
}

TEST_CASE("convex gap: triangles in general position, against what their corners and edges tell") {
    Random random(4);
    int n_apart = 0;
    for (int i = 0; i < 5000; ++i) {
        std::array<Vector3, 3> a;
        std::array<Vector3, 3> b;
        for (std::size_t k = 0; k < 3; ++k) {
            a[k] = random.in_cube();
            b[k] = random.in_cube() + 1.2 * Vector3::UnitX();
        }
        const ConvexGap found = find_convex_gap(Vector3(a[0] - b[0]), [&](const Vector3& d) {
            const auto along = [&d](const Vector3& p) { return d.dot(p); };
            return Vector3(*std::ranges::max_element(a, {}, along) -
                           *std::ranges::min_element(b, {}, along));
        });
        // An upper bound by points of one and their nearest on the other.
        double least = 10.0;
        for (int u = 0; u <= 20; ++u) {
            for (int v = 0; u + v <= 20; ++v) {
                const Vector3 p = a[0] + 0.05 * u * (a[1] - a[0]) + 0.05 * v * (a[2] - a[0]);
                least = std::min(least, (p - find_nearest_on_triangle(p, b[0], b[1], b[2])).norm());
            }
        }
        REQUIRE(found.gap_m <= least + 1.0e-12);
        if (found.gap_m > 0.0) {
            ++n_apart;
            REQUIRE(found.gap_m >= least - 0.1);  // as fine as the points are
            for (std::size_t k = 0; k < 9; ++k) {
                REQUIRE(found.normal.dot(a[k / 3] - b[k % 3]) >= found.gap_m - 1.0e-12);
            }
        }
    }
    CHECK(n_apart > 2000);
    CHECK(n_apart < 5000);
}

TEST_CASE("convex gap: faces that lie parallel, at any distance and size") {
    for (const double scale : {1e-4, 1.0, 1e3}) {
        const ConvexCore box{.kind = Kind::box, .half_m = scale * Vector3(1.0, 0.5, 0.2)};
        const ConvexCore other{.kind = Kind::box, .half_m = scale * Vector3(0.3, 0.3, 0.3)};
        for (const double gap : {1.0, 1e-3, 1e-6, 1e-9}) {
            const Vector3 at = scale * Vector3(0.1, 0.8 + gap, 0.05);
            const ConvexGap found = find_convex_gap(at, [&](const Vector3& d) {
                return Vector3(at + other.find_support(d) - box.find_support(-d));
            });
            CHECK(found.gap_m == Approx(scale * gap).margin(1e-15 * scale));
            CHECK((found.normal - Vector3::UnitY()).norm() < 1e-6);
        }
    }
}

TEST_CASE("convex gap: supports and bounding spheres of the cores") {
    const ConvexCore cylinder{.kind = Kind::cylinder, .half_m = {2.0, 1.0, 0.0}, .radius_m = 0.5};
    CHECK(cylinder.find_support({3.0, -1.0, 4.0}).isApprox(Vector3(1.2, -1.0, 1.6)));
    CHECK(cylinder.find_support({0.0, 1.0, 0.0}) == Vector3(0.0, 1.0, 0.0));
    CHECK(cylinder.bounding_radius_m() == Approx(std::sqrt(5.0) + 0.5));
    const std::array<Vector3, 2> cloud{Vector3(1, 2, 2), Vector3(-1, 0, 0)};
    const ConvexCore core{.kind = Kind::cloud, .cloud = cloud};
    CHECK(core.find_support({-1.0, 0.1, 0.1}) == Vector3(-1, 0, 0));
    CHECK(core.bounding_radius_m() == 3.0);
    CHECK(ConvexCore{.radius_m = 0.1}.bounding_radius_m() == 0.1);
}

}  // namespace
}  // namespace fulcrum
