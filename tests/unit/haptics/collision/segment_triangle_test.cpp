#include "haptics/collision/segment_triangle.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

namespace fulcrum {
namespace {

const PreparedTriangle kTriangle =
    prepare_triangle(Vector3(0.0, 0.0, 0.0), Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0), 42);

TEST_CASE("segment and triangle: t, side and number of a meeting from the front and from behind") {
    const Vector3 above(0.2, 0.3, 3.0);
    const Vector3 below(0.2, 0.3, -1.0);
    const SegmentHit down = meet(kTriangle, above, below);
    CHECK(down.triangle == 42);
    CHECK(down.t == 0.75);
    CHECK(down.side == 1);
    const SegmentHit up = meet(kTriangle, below, above);
    CHECK(up.t == 0.25);
    CHECK(up.side == -1);
}

TEST_CASE(
    "segment and triangle: corners and edges belong to it, one step of a coordinate beside them "
    "does not") {
    const auto falls_on = [](double x, double y) {
        return meet(kTriangle, Vector3(x, y, 1.0), Vector3(x, y, -1.0)).found();
    };
    for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(0.0, 1.0),
                               std::pair(0.5, 0.5), std::pair(0.25, 0.0), std::pair(0.0, 0.75)}) {
        CHECK(falls_on(x, y));
    }
    CHECK_FALSE(falls_on(0.25, -5e-324));
    CHECK_FALSE(falls_on(-5e-324, 0.25));
    CHECK_FALSE(falls_on(std::nextafter(0.5, 1.0), 0.5));
    CHECK(falls_on(std::nextafter(0.5, 0.0), 0.5));
}

TEST_CASE("segment and triangle: an end in the plane is a meeting, an end one step above is none") {
    const Vector3 above(0.25, 0.25, 1.0);
    CHECK(meet(kTriangle, above, Vector3(0.25, 0.25, 0.0)).t == 1.0);
    CHECK(meet(kTriangle, Vector3(0.25, 0.25, 0.0), above).t == 0.0);
    CHECK(meet(kTriangle, Vector3(0.25, 0.25, 0.0), above).side ==
          -1);  // it came from behind, to go up
    CHECK_FALSE(meet(kTriangle, above, Vector3(0.25, 0.25, 1e-300)).found());
    CHECK_FALSE(meet(kTriangle, above, Vector3(0.25, 0.25, 5e-324)).found());
}

TEST_CASE(
    "segment and triangle: within the plane it meets the first edge, or its start when that lies "
    "inside") {
    const SegmentHit across = meet(kTriangle, Vector3(-1.0, 0.25, 0.0), Vector3(1.0, 0.25, 0.0));
    CHECK(across.t == 0.5);
    CHECK(across.side == 0);
    CHECK(meet(kTriangle, Vector3(0.25, 0.25, 0.0), Vector3(5.0, 0.25, 0.0)).t == 0.0);
    CHECK_FALSE(meet(kTriangle, Vector3(-1.0, 1.25, 0.0), Vector3(1.0, 1.25, 0.0)).found());
    CHECK_FALSE(meet(kTriangle, Vector3(-1.0, 0.25, 0.0), Vector3(-0.5, 0.25, 0.0)).found());
    CHECK_FALSE(meet(kTriangle, Vector3(2.0, 0.0, 0.0), Vector3(3.0, 0.0, 0.0)).found());
    CHECK(meet(kTriangle, Vector3(3.0, 0.0, 0.0), Vector3(-3.0, 0.0, 0.0)).t ==
          Approx(1.0 / 3.0).epsilon(1e-15));
    // Also in a plane that is not one of the axes', and for one seen from its other side.
    const PreparedTriangle tilted =
        prepare_triangle(Vector3(0, 0, 1), Vector3(0, 1, 0), Vector3(1, 0, 0), 7);
    CHECK(meet(tilted, Vector3(3.0, -1.0, -1.0), Vector3(-1.0, 1.0, 1.0)).t == 0.5);
}

TEST_CASE("segment and triangle: a single point meets only where it lies") {
    const Vector3 inside(0.25, 0.25, 0.0);
    CHECK(meet(kTriangle, inside, inside).found());
    CHECK_FALSE(meet(kTriangle, Vector3(1.0, 1.0, 0.0), Vector3(1.0, 1.0, 0.0)).found());
    CHECK_FALSE(meet(kTriangle, Vector3(0.25, 0.25, 1e-20), Vector3(0.25, 0.25, 1e-20)).found());
}

TEST_CASE("segment and triangle: the nearer of two comes first, of equals the lower number") {
    const SegmentHit near{0.25, 3, 1};
    const SegmentHit far{0.5, 2, 1};
    const SegmentHit equal{0.25, 4, -1};
    CHECK(near.is_before(far));
    CHECK_FALSE(far.is_before(near));
    CHECK(near.is_before(equal));
    CHECK_FALSE(equal.is_before(near));
    CHECK(near.is_before(SegmentHit{}));
}

TEST_CASE("segment and triangle: within the plane each edge belongs to it, also along itself") {
    const std::array corners{kTriangle.a, kTriangle.b, kTriangle.c};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3& from = corners[i];
        const Vector3& to = corners[(i + 1) % 3];
        const Vector3 near = 0.75 * from + 0.25 * to;
        const Vector3 far = 0.25 * from + 0.75 * to;
        const SegmentHit along = meet(kTriangle, near, far);
        CHECK(along.found());
        CHECK(along.t == 0.0);
        CHECK(meet(kTriangle, near, near).found());
    }
}

TEST_CASE("segment and triangle: a height that rounding eats in every sign is a meeting still") {
    // Seen from its middle each edge spans products below a half: times the smallest number, zero.
    const PreparedTriangle even = prepare_triangle(Vector3(0.0, 0.0, 0.0), Vector3(1.0, 0.0, 0.0),
                                                   Vector3(0.5, 0.875, 0.0), 1);
    const Vector3 middle(0.5, 0.29, 0.0);
    const Vector3 just_above(0.5, 0.29, 5e-324);
    REQUIRE(orientation(just_above, middle, even.a, even.b) == 0);
    REQUIRE(orientation(just_above, middle, even.b, even.c) == 0);
    REQUIRE(orientation(just_above, middle, even.c, even.a) == 0);
    CHECK(meet(even, just_above, middle).found());
    CHECK(meet(even, middle, just_above).found());
}

}  // namespace
}  // namespace fulcrum
