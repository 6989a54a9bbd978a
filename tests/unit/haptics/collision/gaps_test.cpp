// How far a point or a body is from another: shape_gap.h and triangle_gap.h in closed form, convex_gap.h and convex_depth.h by search.
#include "haptics/collision/convex_depth.h"
#include "haptics/collision/convex_gap.h"
#include "haptics/collision/shape_gap.h"
#include "haptics/collision/triangle_gap.h"
#include "haptics/geometry/triangle_mesh.h"
#include "tests/support/contact_shapes.h"
#include "tests/support/nearest_point.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {
namespace {

template <class Shape>
void check_gap(const Shape& shape, const Vector3& p, const Vector3& normal, double gap_m,
               double curvature_per_m) {
    const Gap gap = find_gap(shape, p);
    CAPTURE(p);
    CHECK(gap.gap_m == Approx(gap_m));
    CHECK((gap.normal_B - normal.normalized()).norm() < 1e-14);
    CHECK(gap.curvature_per_m == Approx(curvature_per_m));
}

// A gap of a convex shape: it changes by as much as one goes along the normal, and never by more; a tangent lies below it.
template <class Shape>
void check_law(const Shape& shape, unsigned seed) {
    Random random(seed);
    for (int i = 0; i < 20000; ++i) {
        const Vector3 p = 3.0 * random.in_cube();
        const Vector3 q = p + std::pow(10.0, -(i % 6)) * random.in_cube();
        const Gap at_p = find_gap(shape, p);
        const Gap at_q = find_gap(shape, q);
        REQUIRE(at_p.normal_B.norm() == Approx(1.0));
        REQUIRE(at_q.gap_m >= at_p.gap_m + at_p.normal_B.dot(q - p) - 1.0e-12);
        REQUIRE(std::abs(at_q.gap_m - at_p.gap_m) <= (q - p).norm() + 1.0e-12);
        if (at_p.gap_m > 0.0) {
            REQUIRE(std::abs(find_gap(shape, p - at_p.gap_m * at_p.normal_B).gap_m) <= 1.0e-12);
        }
    }
}

TEST_CASE("shape gap: closed forms, convex, and the normal is the shortest way out") {
    const SphereShape sphere{2.0};
    check_gap(sphere, {3, 0, 4}, {3, 0, 4}, 3.0, 1.0 / 5.0);
    check_gap(sphere, {0, -0.5, 0}, {0, -1, 0}, -1.5, 2.0);
    const BoxShape box{{1.0, 2.0, 3.0}};
    check_gap(box, {0.5, 2.5, -1.0}, {0, 1, 0}, 0.5, 0.0);
    check_gap(box, {-1.3, 2.4, 0.0}, {-0.3, 0.4, 0}, 0.5, 2.0);
    check_gap(box, {2.0, -4.0, 5.0}, {1, -2, 2}, 3.0, 1.0 / 3.0);
    check_gap(box, {-0.9, 1.0, 1.0}, {-1, 0, 0}, -0.1, 0.0);
    CHECK(find_gap(box, {-1.3, 2.4, 0.0}).straight_B == Vector3::UnitZ());
    const CapsuleShape capsule{0.5, 1.0};
    check_gap(capsule, {0.0, 0.3, 2.0}, {0, 0, 1}, 1.5, 0.5);
    check_gap(capsule, {3.0, 5.0, 0.0}, {3, 4, 0}, 4.5, 0.2);
    CHECK(find_gap(capsule, {0.0, 0.3, 2.0}).straight_B == Vector3::UnitY());
    const CylinderShape cylinder{2.0, 1.0};
    check_gap(cylinder, {3, 0.5, 4}, {3, 0, 4}, 3.0, 1.0 / 5.0);
    check_gap(cylinder, {1, -1.5, 1}, {0, -1, 0}, 0.5, 0.0);
    check_gap(cylinder, {2.3, 1.4, 0}, {0.3, 0.4, 0}, 0.5, 2.0);
    check_gap(cylinder, {0.1, 0.7, 0}, {0, 1, 0}, -0.3, 0.0);
    check_gap(cylinder, {-1.8, 0.2, 0}, {-1, 0, 0}, -0.2, 1.0 / 1.8);
    check_law(SphereShape{1.0}, 1);
    check_law(BoxShape{{1.0, 0.5, 0.2}}, 2);
    check_law(CapsuleShape{0.4, 1.0}, 3);
    check_law(CapsuleShape{0.4, 0.0}, 4);
    check_law(CylinderShape{0.7, 0.5}, 5);
}

TEST_CASE("shape gap: the middle has a way out too; an edge bends until its face is reached") {
    CHECK(find_gap(SphereShape{1.0}, Vector3::Zero()).gap_m == -1.0);
    CHECK(find_gap(CapsuleShape{0.3, 1.0}, Vector3::Zero()).gap_m == -0.3);
    CHECK(find_gap(CylinderShape{0.3, 1.0}, Vector3::Zero()).gap_m == -0.3);
    CHECK(find_gap(BoxShape{{0.3, 1.0, 1.0}}, Vector3::Zero()).gap_m == -0.3);
    CHECK(bounding_radius_m(SphereShape{2.0}) == 2.0);
    CHECK(bounding_radius_m(BoxShape{{1.0, 2.0, 2.0}}) == 3.0);
    CHECK(bounding_radius_m(CapsuleShape{0.5, 1.0}) == 1.5);
    CHECK(bounding_radius_m(CylinderShape{3.0, 4.0}) == 5.0);
    const BoxShape box{{1.0, 1.0, 1.0}};
    const Vector3 over_edge(1.001, 1.1, 0.0);
    CHECK(find_bend(box, over_edge, Vector3(-1, 0, 0)) == Approx(0.001));
    CHECK(find_bend(box, over_edge, Vector3(1, 0, 0)) == Approx(0.5 * std::hypot(0.001, 0.1)));
    const CylinderShape cylinder{1.0, 1.0};
    CHECK(find_bend(cylinder, Vector3(1.1, 1.001, 0.0), Vector3(0, -1, 0)) == Approx(0.001));
    CHECK(find_bend(CapsuleShape{0.5, 1.0}, Vector3(0.5, -1.001, 0.0), Vector3(0, 1, 0)) ==
          Approx(0.001));
    CHECK(find_bend(SphereShape{1.0}, Vector3(0, 2, 0), Vector3(1, 0, 0)) == Approx(1.0));
}

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
    // On it, zero, and the direction the front's.
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

using Kind = ConvexCore::Kind;

// A point against a core, and against the same shape in closed form.
template <class Shape>
void compare(const ConvexCore& core, const Shape& shape, unsigned seed) {
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const Vector3 p = std::pow(10.0, (i % 5) - 2) * random.in_cube() + 0.3 * random.direction();
        const Gap exact = find_gap(shape, p);
        const ConvexGap found = find_convex_gap(p, [&](const Vector3& direction) {
            return Vector3(p - core.find_support(-direction));
        });
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

TEST_CASE("convex gap: closed forms of points, parallel faces, supports and spheres of cores") {
    compare({.kind = Kind::box, .half_m = {1.0, 0.5, 0.2}}, BoxShape{{1.0, 0.5, 0.2}}, 1);
    compare({.kind = Kind::cylinder, .half_m = {0.7, 0.5, 0.0}}, CylinderShape{0.7, 0.5}, 2);
    compare({.kind = Kind::segment, .half_m = {0.0, 1.0, 0.0}}, CapsuleShape{0.0, 1.0}, 3);
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

const ContactShape kPoint = make_contact_shape(SphereShape{1.0}).value();  // its core is one
const ContactShape kFlatBox = make_contact_shape(BoxShape{{1.0, 0.5, 0.7}}).value();
const ContactShape kCan = make_contact_shape(CylinderShape{0.6, 0.8}).value();

ConvexGap find_depth(const PlacedShape& a, const PlacedShape& b) {
    return find_convex_depth(
        [&](const Vector3& d) noexcept { return Vector3(a.find_support(d) - b.find_support(-d)); });
}

TEST_CASE("convex depth: out by the nearest face, by sign at a touch, along a normal if thin") {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const PlacedShape point{.shape = &kPoint, .place = 0.5 * random.in_cube()};
        const ConvexGap in_box = find_depth(point, {.shape = &kFlatBox});
        const Gap exact = find_gap(BoxShape{{1.0, 0.5, 0.7}}, point.place);
        REQUIRE(in_box.gap_m == Approx(exact.gap_m).margin(1.0e-12));
        REQUIRE(in_box.normal.dot(exact.normal_B) == Approx(1.0).margin(1.0e-12));
        const ConvexGap in_can = find_depth(point, {.shape = &kCan});
        const double depth = find_gap(CylinderShape{0.6, 0.8}, point.place).gap_m;
        // A round side is met as a polygon that grows until what is left is 1e-6 of the size.
        REQUIRE(in_can.gap_m <= depth + 1.0e-12);
        REQUIRE(in_can.gap_m >= depth - 4.0e-6);
    }
    const auto box = make_contact_shape(BoxShape{{1.0, 1.0, 1.0}}).value();
    for (const double gap_m : {-1.0e-9, 0.0, 1.0e-9, 0.3}) {
        const ConvexGap found =
            find_depth({.shape = &box, .place = {0.2, 2.0 + gap_m, -0.1}}, {.shape = &box});
        CHECK(found.gap_m == Approx(gap_m).margin(1.0e-15));
        CHECK(found.normal.y() == Approx(1.0));
    }
    const auto capsule = make_contact_shape(CapsuleShape{0.1, 1.0}).value();
    const ConvexGap found = find_depth({.shape = &kPoint}, {.shape = &capsule});
    CHECK(found.gap_m == Approx(0.0).margin(1.0e-15));
    CHECK(found.normal.y() == Approx(0.0).margin(1.0e-12));
    const ConvexGap same = find_depth({.shape = &kPoint}, {.shape = &kPoint});
    CHECK(same.gap_m == 0.0);
    CHECK(same.normal.norm() == Approx(1.0));
}

TEST_CASE("convex depth: from whichever four points it is as deep, and no direction parts sooner") {
    Random random(3);
    int n_tried = 0;
    for (int i = 0; i < 500; ++i) {
        const PlacedShape a{.shape = &kFlatBox};
        const PlacedShape b{.shape = &kCan, .place = 0.4 * random.in_cube()};
        const auto find_support = [&](const Vector3& d) noexcept {
            return Vector3(a.find_support(d) - b.find_support(-d));
        };
        std::array<Vector3, 4> from;
        for (Vector3& corner : from) {
            corner = find_support(random.in_cube().normalized());
        }
        Matrix3 edges;
        edges << from[1] - from[0], from[2] - from[0], from[3] - from[0];
        if (std::abs(edges.determinant()) < 0.1) {
            continue;
        }
        ++n_tried;
        const ConvexGap found = find_convex_depth(find_support, from);
        REQUIRE(found.gap_m == Approx(find_convex_depth(find_support).gap_m).margin(8.0e-6));
        REQUIRE(found.gap_m == Approx(-find_support(-found.normal).dot(-found.normal)));
    }
    CHECK(n_tried > 100);
    random = Random(2);
    const auto shapes = make_contact_shapes(1.0);
    for (int i = 0; i < 60; ++i) {
        const auto& a = shapes[2 + static_cast<std::size_t>(i % 3)];
        const auto& b = shapes[2 + static_cast<std::size_t>(i / 3 % 3)];
        const PlacedShape first{&a, random.turn(3.0).toRotationMatrix(), 0.3 * random.in_cube()};
        const PlacedShape second{&b, random.turn(3.0).toRotationMatrix()};
        const ConvexGap found = find_depth(first, second);
        REQUIRE(find_gap_along(first, second, found.normal) == Approx(found.gap_m).margin(1e-12));
        REQUIRE(found.gap_m >= search_gap_m(first, second) - 1.0e-5);
    }
}

}  // namespace
}  // namespace fulcrum
