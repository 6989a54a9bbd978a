#include "haptics/voxel/distance_field.h"

#include "tests/support/field_parts.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

struct Fixture {
    TriangleMesh mesh;
    TriangleClusters clusters;
    DistanceField field;
};

Fixture make(const TriangleMesh& mesh, int n_along) {
    return {mesh, TriangleClusters(mesh), test::build_field(mesh, n_along)};
}

const Fixture& bumpy() {
    static const Fixture kBumpy = make(*make_bumpy_sphere(1.0, 16, 0.05, 12.0), 64);
    return kBumpy;
}

}  // namespace

TEST_CASE("distance field: a ball's is its closed form within the bound of spheres") {
    // So fine a mesh lies within 2e-5 of the sphere.
    const Fixture ball = make(*make_sphere(1.0, 120), 128);
    const DistanceField& field = ball.field;
    const double s = field.frame().voxel_m;
    constexpr double kFacets_m = 4.0e-5;
    Random random(1);
    for (int i = 0; i < 5000; ++i) {
        const double r = 1.0 + 1.25 * s * random.uniform();  // all corners within the band
        const Vector3 n = random.direction();
        const DistanceSample sample = field.sample(r * n);
        const double bound = s * s / (4.0 * (r - s)) + 0.5 * field.step_m() + kFacets_m;
        CHECK(std::abs(sample.value_m - (r - 1.0)) < bound);
        // A slope of a trilinear cell is off by the bend over it.
        CHECK((sample.slope - n).norm() < 2.0 * s + 2.0 * kFacets_m / s);
    }
}

TEST_CASE("distance field: a box's is its closed form on all sides, to the steps of 16 bits") {
    const Fixture box = make(*make_box({1.0, 0.6, 0.8}), 64);
    const double s = box.field.frame().voxel_m;
    Random random(2);
    for (int i = 0; i < 3000; ++i) {
        // Over the middle of a face the field is linear.
        const Vector3 p(0.3 * random.uniform(), 0.3 + 1.9 * s * random.uniform(),
                        0.2 * random.uniform());
        const DistanceSample sample = box.field.sample(p);
        CHECK(std::abs(sample.value_m - (p.y() - 0.3)) < box.field.step_m());
        CHECK((sample.slope - Vector3::UnitY()).norm() < 1.0e-3);
    }
    CHECK(box.field.sample(Vector3::Zero()).value_m == Approx(-box.field.band_m()));
    CHECK(box.field.sample(Vector3::Zero()).slope.norm() == 0.0);
}

TEST_CASE("distance field: within the stated error of brute force, on a bumpy mesh") {
    const auto& [mesh, clusters, field] = bumpy();
    Random random(3);
    for (int i = 0; i < 5000; ++i) {
        const Vector3 p = (1.0 + 0.1 * random.uniform()) * random.direction();
        const double exact = clusters.find_distance(p);
        const double value = std::abs(field.sample(p).value_m);
        if (exact < field.band_m() - field.error_bound_m()) {
            CHECK(std::abs(value - exact) < field.error_bound_m());
        } else {
            CHECK(value > exact - field.error_bound_m() - 0.06);
        }
    }
}

TEST_CASE("distance field: continuous, and nowhere steeper than its slope bound") {
    const DistanceField& field = bumpy().field;
    CHECK(field.slope_bound() >= 1.0);
    CHECK(field.slope_bound() < 1.74);
    Random random(4);
    const double s = field.frame().voxel_m;
    for (int i = 0; i < 20000; ++i) {
        const Vector3 p = (1.0 + 0.2 * random.uniform()) * random.direction();
        const Vector3 q =
            p + std::pow(10.0, -3.0 + 3.0 * random.uniform()) * s * random.direction();
        const double change = std::abs(field.sample(p).value_m - field.sample(q).value_m);
        CHECK(change <= field.slope_bound() * (p - q).norm() + 1.0e-12);
    }
}

TEST_CASE("distance field: its slope is the derivative of its value") {
    const DistanceField& field = bumpy().field;
    const double s = field.frame().voxel_m;
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const Vector3 lattice =
            field.frame().to_lattice((1.0 + 0.05 * random.uniform()) * random.direction());
        // Within a cell, so that no face is crossed.
        const Vector3 p =
            field.frame().lower_O +
            s * (lattice.cwiseFloor() + Vector3::Constant(0.5 + 0.4 * random.uniform()));
        for (int axis = 0; axis < 3; ++axis) {
            const Vector3 step = 1.0e-3 * s * Vector3::Unit(axis);
            const double slope =
                (field.sample(p + step).value_m - field.sample(p - step).value_m) / (2.0e-3 * s);
            CHECK(slope == Approx(field.sample(p).slope[axis]).margin(1.0e-9));
        }
    }
}

TEST_CASE(
    "distance field: bounds are below the distance, near, far, inside and outside the block") {
    const auto& [mesh, clusters, field] = bumpy();
    Random random(6);
    for (int i = 0; i < 3000; ++i) {
        const Vector3 p = 4.0 * std::abs(random.uniform()) * random.in_cube();
        const double exact = clusters.find_distance(p);
        const double bound = field.bound_distance_m(p);
        CHECK(std::abs(bound) <= exact);
        if (bound != 0.0 && std::abs(p.norm() - 1.0) > 0.06) {
            CHECK((bound < 0.0) == (p.norm() < 1.0));
        }
        // Far off it is known to a few parts in a hundred and a brick.
        CHECK(std::abs(bound) > 0.9 * exact - 14.0 * field.frame().voxel_m);
    }
}

TEST_CASE("distance field: everything within the free radius is free") {
    const DistanceField& field = bumpy().field;
    Random random(7);
    int n_free = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vector3 p = (1.2 + 0.4 * random.uniform()) * random.direction();
        const double radius = field.find_free_radius_m(p);
        if (radius > 0.0) {
            ++n_free;
            CHECK(field.sample(p + radius * random.direction()).value_m > 0.0);
        }
        CHECK((radius == 0.0 || field.sample(p).value_m > 0.0));
    }
    CHECK(n_free > 10000);
    CHECK(field.find_free_radius_m(Vector3::Zero()) == 0.0);
}

TEST_CASE("distance field: deeper than the band the depth goes on, and the way out with it") {
    // 120 voxels along each edge, so that there is much that is deeper than 3.
    const Fixture box = make(*make_box({1.0, 1.0, 1.0}), 128);
    const double s = box.field.frame().voxel_m;
    Random random(12);
    double deepest_voxels = 0.0;
    for (int i = 0; i < 3000; ++i) {
        const Vector3 p = 0.5 * random.in_cube();
        // Depths by face, largest coordinate first; where two are within 16 voxels the coarse depth is flatter.
        Vector3 beside = p.cwiseAbs();
        int axis = 0;
        beside.maxCoeff(&axis);
        const double depth_m = 0.5 - beside[axis];
        beside[axis] = 0.0;
        const DepthSample sample = box.field.sample_depth(p);
        CHECK(sample.depth_m <= depth_m + 0.01 * s);
        if (0.5 - beside.maxCoeff() - depth_m > 16.0 * s && depth_m > 0.01 * s) {
            const Vector3 out = (p[axis] > 0.0 ? 1.0 : -1.0) * Vector3::Unit(axis);
            // Centres outside are known to 3 % of some voxels.
            CHECK(sample.depth_m == Approx(depth_m).margin(0.1 * s));
            CHECK((sample.way_out - out).norm() < 0.03);
            deepest_voxels = std::max(deepest_voxels, depth_m / s);
        }
    }
    CHECK(deepest_voxels > 30.0);
    CHECK(box.field.sample_depth({0.6, 0.0, 0.0}).depth_m == 0.0);
    CHECK(box.field.sample_depth({0.6, 0.0, 0.0}).way_out == Vector3::Zero());
}

TEST_CASE("distance field: the way out is the depth's slope, and the depth is continuous") {
    const Fixture& ball = bumpy();
    const double s = ball.field.frame().voxel_m;
    Random random(13);
    constexpr double kWay_m = 1.0e-6;
    int n_deep = 0;
    int n_off = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vector3 p = 1.05 * random.in_cube();
        const Vector3 way = kWay_m * random.direction();
        const DepthSample here = ball.field.sample_depth(p);
        const DepthSample there = ball.field.sample_depth(p + way);
        const double change_m = there.depth_m - here.depth_m;
        // The band's last quarter is the steepest: 1 + 4 K/b, and K is small there but between close walls.
        CHECK(std::abs(change_m) < 4.0 * kWay_m);
        if (here.depth_m > 0.0 && there.depth_m > 0.0) {
            // Off only where a face between cells lies between both.
            n_off += std::abs(change_m + here.way_out.dot(way)) > 1.0e-2 * kWay_m ? 1 : 0;
            n_deep += here.depth_m > 4.0 * s ? 1 : 0;
        }
    }
    CHECK(n_deep > 3000);
    CHECK(n_off < 20);
}

TEST_CASE("distance field: what is thinner than a brick, or one brick long, has its depths too") {
    const Fixture thin = make(*make_box({1.0, 0.02, 0.3}), 64);
    for (const double y : {0.0, 0.004, 0.009}) {
        CHECK(thin.field.sample_depth({0.1, y, 0.0}).depth_m ==
              -thin.field.sample({0.1, y, 0.0}).value_m);
    }
}
