#include "haptics/collision/shape_gap.h"

#include "tests/support/wander.h"

#include <catch2/catch.hpp>

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

TEST_CASE("shape gap: closed forms outside and inside of each shape") {
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

TEST_CASE("shape gap: it is convex, and the way along the normal is the shortest out") {
    check_law(SphereShape{1.0}, 1);
    check_law(BoxShape{{1.0, 0.5, 0.2}}, 2);
    check_law(CapsuleShape{0.4, 1.0}, 3);
    check_law(CapsuleShape{0.4, 0.0}, 4);
    check_law(CylinderShape{0.7, 0.5}, 5);
}

TEST_CASE("shape gap: in the very middle there is a way out too") {
    CHECK(find_gap(SphereShape{1.0}, Vector3::Zero()).gap_m == -1.0);
    CHECK(find_gap(CapsuleShape{0.3, 1.0}, Vector3::Zero()).gap_m == -0.3);
    CHECK(find_gap(CylinderShape{0.3, 1.0}, Vector3::Zero()).gap_m == -0.3);
    CHECK(find_gap(BoxShape{{0.3, 1.0, 1.0}}, Vector3::Zero()).gap_m == -0.3);
}

TEST_CASE("shape gap: an edge bends until its face is reached") {
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

TEST_CASE("shape gap: the bounding sphere holds the shape") {
    CHECK(bounding_radius_m(SphereShape{2.0}) == 2.0);
    CHECK(bounding_radius_m(BoxShape{{1.0, 2.0, 2.0}}) == 3.0);
    CHECK(bounding_radius_m(CapsuleShape{0.5, 1.0}) == 1.5);
    CHECK(bounding_radius_m(CylinderShape{3.0, 4.0}) == 5.0);
}

}  // namespace
}  // namespace fulcrum
