#include "haptics/dynamics/shape_inertia.h"

#include "haptics/geometry/shape.h"
#include "tests/support/distance_bodies.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace fulcrum {
namespace {

// A round shape's mesh lies inside it: off by the square of the angle between its sides.
constexpr double kFacets = 2.0e-3;

void compare(const SolidShape& shape, const Expected<TriangleMesh>& mesh, double within) {
    const MeshInertia exact = compute_shape_inertia(shape, 700.0).value();
    const MeshInertia meshed = compute_inertia(mesh.value(), 700.0).value();
    CHECK(exact.volume_m3 == Approx(meshed.volume_m3).epsilon(within));
    CHECK(exact.inertia.mass_kg == Approx(700.0 * exact.volume_m3));
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(exact.inertia_B(axis, axis) == Approx(meshed.inertia_B(axis, axis)).epsilon(within));
        CHECK(exact.inertia.moments_kg_m2[axis] == exact.inertia_B(axis, axis));
    }
    CHECK(exact.X_BP.position == Vector3::Zero());
}

TEST_CASE("shape inertia: closed forms are what the integrals over a fine mesh tell") {
    compare(BoxShape{{0.1, 0.2, 0.3}}, make_box({0.2, 0.4, 0.6}), 1.0e-12);
    compare(SphereShape{0.1}, make_sphere(0.1, 40), kFacets);
    compare(CylinderShape{0.1, 0.3}, make_cylinder(0.1, 0.6, 200), kFacets);
    compare(CapsuleShape{0.1, 0.2}, make_capsule(0.1, 0.4, 200, 60), kFacets);
}

TEST_CASE("shape inertia: a capsule without length is a ball, and a mass is what it should be") {
    const auto capsule = compute_shape_inertia(CapsuleShape{0.1, 0.0}, 500.0).value();
    const auto ball = compute_shape_inertia(SphereShape{0.1}, 500.0).value();
    CHECK((capsule.inertia.moments_kg_m2 - ball.inertia.moments_kg_m2).norm() < 1.0e-15);
    const auto heavy = compute_shape_inertia_of_mass(BoxShape{{0.1, 0.2, 0.3}}, 12.0).value();
    CHECK(heavy.inertia.mass_kg == Approx(12.0));
    CHECK(heavy.inertia.moments_kg_m2.x() == Approx(12.0 / 3.0 * (0.04 + 0.09)));
}

TEST_CASE("shape inertia: a hull's centre of mass and axes are its own") {
    std::vector<Vector3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back(i & 1 ? 0.3 : 0.1, i & 2 ? 0.2 : -0.2, i & 4 ? 0.1 : -0.1);
    }
    const auto hull = compute_shape_inertia_of_mass(make_hull_shape(corners).value(), 3.0).value();
    CHECK((hull.X_BP.position - Vector3(0.2, 0.0, 0.0)).norm() < 1.0e-12);
    CHECK(hull.inertia.mass_kg == Approx(3.0));
    const auto box = make_box_inertia(3.0, {0.2, 0.4, 0.2});
    CHECK(hull.inertia_B(1, 1) == Approx(box.moments_kg_m2.y()));
    const auto mesh = compute_shape_inertia(touchable(make_box({0.2, 0.4, 0.6})), 100.0).value();
    CHECK(mesh.inertia.mass_kg == Approx(4.8));
}

TEST_CASE("shape inertia: what encloses nothing, has no density or is too light is refused") {
    CHECK_FALSE(compute_shape_inertia(SphereShape{0.1}, 0.0));
    CHECK_FALSE(compute_shape_inertia(SphereShape{0.1}, std::nan("")));
    CHECK_FALSE(compute_shape_inertia_of_mass(SphereShape{0.1}, -1.0));
    CHECK_FALSE(compute_shape_inertia(SphereShape{-0.1}, 100.0));
    CHECK_FALSE(compute_shape_inertia(SphereShape{1.0e-9}, 1.0));
    const auto function =
        compute_shape_inertia(DistanceShape{std::make_shared<BallFunction>(0.1)}, 1.0);
    REQUIRE_FALSE(function);
    CHECK(to_sentence(function.error()).find("volume") != std::string::npos);
}

}  // namespace
}  // namespace fulcrum
