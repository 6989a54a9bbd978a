#include "haptics/collision/convex_depth.h"

#include "haptics/collision/shape_gap.h"
#include "tests/support/contact_shapes.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

ConvexGap find_depth(const PlacedShape& a, const PlacedShape& b) {
    return find_convex_depth(
        [&](const Vector3& d) noexcept { return Vector3(a.find_support(d) - b.find_support(-d)); });
}

TEST_CASE("convex depth: a point inside a box or a cylinder goes out by the nearest face") {
    const auto point = make_contact_shape(SphereShape{1.0}).value();
    const auto box = make_contact_shape(BoxShape{{1.0, 0.5, 0.7}}).value();
    const auto cylinder = make_contact_shape(CylinderShape{0.6, 0.8}).value();
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const Vector3 p = 0.5 * random.in_cube();
        const ConvexGap in_box = find_depth({.shape = &point, .place = p}, {.shape = &box});
        const Gap exact = find_gap(BoxShape{{1.0, 0.5, 0.7}}, p);
        REQUIRE(in_box.gap_m == Approx(exact.gap_m).margin(1.0e-12));
        REQUIRE(in_box.normal.dot(exact.normal_B) == Approx(1.0).margin(1.0e-12));
        const ConvexGap in_cylinder =
            find_depth({.shape = &point, .place = p}, {.shape = &cylinder});
        const double depth = find_gap(CylinderShape{0.6, 0.8}, p).gap_m;
        // A round side is met as a polygon that grows until what is left is 1e-6 of the size.
        REQUIRE(in_cylinder.gap_m <= depth + 1.0e-12);
        REQUIRE(in_cylinder.gap_m >= depth - 4.0e-6);
    }
}

TEST_CASE(
    "convex depth: bodies that only just touch, and bodies apart by faces, tell it with a sign") {
    const auto box = make_contact_shape(BoxShape{{1.0, 1.0, 1.0}}).value();
    for (const double gap_m : {-1.0e-9, 0.0, 1.0e-9, 0.3}) {
        const ConvexGap found =
            find_depth({.shape = &box, .place = {0.2, 2.0 + gap_m, -0.1}}, {.shape = &box});
        CHECK(found.gap_m == Approx(gap_m).margin(1.0e-15));
        CHECK(found.normal.y() == Approx(1.0));
    }
}

TEST_CASE("convex depth: what has no thickness is parted along its normal") {
    const auto sphere = make_contact_shape(SphereShape{1.0}).value();
    const auto capsule = make_contact_shape(CapsuleShape{0.1, 1.0}).value();
    const ConvexGap found = find_depth({.shape = &sphere}, {.shape = &capsule});
    CHECK(found.gap_m == Approx(0.0).margin(1.0e-15));
    CHECK(found.normal.y() == Approx(0.0).margin(1.0e-12));
    const ConvexGap same = find_depth({.shape = &sphere}, {.shape = &sphere});
    CHECK(same.gap_m == 0.0);
    CHECK(same.normal.norm() == Approx(1.0));
}

TEST_CASE("convex depth: from whichever four of their points on it is as deep") {
    Random random(3);
    const auto box = make_contact_shape(BoxShape{{1.0, 0.5, 0.7}}).value();
    const auto cylinder = make_contact_shape(CylinderShape{0.6, 0.8}).value();
    int n_tried = 0;
    for (int i = 0; i < 500; ++i) {
        const PlacedShape a{.shape = &box};
        const PlacedShape b{.shape = &cylinder, .place = 0.4 * random.in_cube()};
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
}

TEST_CASE("convex depth: no direction tried by hand parts bodies sooner") {
    Random random(2);
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
