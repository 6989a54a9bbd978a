#include "haptics/math/rotation.h"
#include "haptics/tool/field_sampling.h"
#include "tests/support/field_parts.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <limits>
#include <numbers>

using namespace fulcrum;

namespace {

FieldSampler make_sampler(const TriangleMesh& object, int n_along, const TriangleMesh& tool,
                          int n_points) {
    return FieldSampler::build(test::make_field(object, n_along), test::make_shell(tool, n_points),
                               {})
        .value();
}

// A ball of 20 mm on a box of 100 mm; voxels of some 1.7 mm.
constexpr double kBall_m = 0.02;
constexpr double kHalf_m = 0.05;
FieldSampler make_ball_on_box() {
    return make_sampler(*make_box(2.0 * Vector3::Constant(kHalf_m)), 64, *make_sphere(kBall_m, 16),
                        4000);
}
Pose at_depth(double depth_m, double x_m = 0.0) {
    return Pose::at({x_m, kHalf_m + kBall_m - depth_m, 0.0});
}

Pose at_share(const Pose& from, const Pose& to, double share) {
    return {from.position + share * (to.position - from.position),
            from.orientation.slerp(share, to.orientation)};
}

}  // namespace

TEST_CASE(
    "field sampling sweep: a thin wall stops a tool at 2 m/s, which steps of a millisecond pass") {
    const double thickness_m = 5.0e-4;
    FieldSampler sampler =
        make_sampler(*make_box({0.1, thickness_m, 0.1}), 512, *make_sphere(2.0e-4, 6), 500);
    const double voxel_m = 0.1 / 504.0;
    const double step_m = 2.0e-3;  // 2 m/s at 1 kHz
    const Pose above = Pose::at({0.01, 0.5 * step_m, 0.01});
    const Pose below = Pose::at({0.01, -0.5 * step_m, 0.01});
    CHECK(sampler.step({}, above).n_touching == 0);
    CHECK(sampler.step({}, below).n_touching == 0);
    const double share = sampler.find_first_touch(above, below);
    const double height_m = 0.5 * step_m - share * step_m;
    const double touch_m = 0.5 * thickness_m + 2.0e-4;
    CHECK(height_m >= touch_m - 1.0e-6);
    CHECK(height_m < touch_m + 0.6 * voxel_m);
    CHECK(sampler.find_first_touch(above, Pose::at({0.02, 0.5 * step_m, 0.03})) == 1.0);
    // From within the wall its lower points would have to go through the middle.
    CHECK(sampler.find_first_touch(Pose::at({0.01, 0.0, 0.01}), above) < 0.1);
}

TEST_CASE(
    "field sampling sweep: no motion passes through what it first touches, turning ones too") {
    FieldSampler sampler = make_sampler(*make_bumpy_sphere(1.0, 16, 0.05, 12.0), 128,
                                        *make_bumpy_sphere(1.0, 16, 0.03, 9.0), 20000);
    Random random(9);
    int n_hits = 0;
    for (int k = 0; k < 60; ++k) {
        const Pose from{2.4 * random.direction(), random.turn(3.0)};
        const Pose to{2.4 * random.direction(), random.turn(3.0)};
        const double share = sampler.find_first_touch(from, to);
        for (int i = 0; i <= 40; ++i) {
            const double t = share * i / 40.0;
            CHECK(sampler.step({}, at_share(from, to, t)).n_touching == 0);
        }
        if (share < 1.0) {
            ++n_hits;
        }
    }
    CHECK(n_hits > 20);
    CHECK(n_hits < 60);
}

TEST_CASE("field sampling sweep: a tool in contact leaves and slides as far as it likes") {
    FieldSampler sampler = make_ball_on_box();
    const Quaternion turned(AngleAxis(0.4, Vector3(1, 2, 3).normalized()));
    for (const double depth_m : {-1.0e-5, 0.0, 1.0e-5, 3.0e-4, 3.0e-3}) {
        INFO(depth_m);
        const Pose from = at_depth(depth_m);
        REQUIRE((depth_m < 1.0e-4 || sampler.step({}, from).n_touching > 0));
        // Out, straight and at a slant; along the face by six voxels; nowhere; turning about the face's normal.
        CHECK(sampler.find_first_touch(from, at_depth(-0.03)) == 1.0);
        CHECK(sampler.find_first_touch(from, at_depth(depth_m - 1.0e-3, 0.01)) == 1.0);
        CHECK(sampler.find_first_touch(from, at_depth(depth_m, 0.01)) == 1.0);
        CHECK(sampler.find_first_touch(from, from) == 1.0);
        const Quaternion spun = compute_exp({0.0, 0.3, 0.0});
        CHECK(sampler.find_first_touch(from, {from.position, spun}) > 0.5);
        // Further in: nothing of it.
        CHECK(sampler.find_first_touch(from, at_depth(depth_m + 2.0e-3)) < 0.1);
    }
    // The same on a box that lies slantwise to the lattice's axes: the tool's frame is what is turned.
    const Pose from{at_depth(1.0e-4).position, turned};
    CHECK(sampler.find_first_touch(from, {at_depth(1.0e-4, 0.01).position, turned}) == 1.0);
}

TEST_CASE("field sampling sweep: what is let in is let in as deep, and no deeper") {
    FieldSampler sampler = make_ball_on_box();
    const double voxel_m = 2.0 * kHalf_m / 55.98;
    for (const double deepest_m : {0.0, 5.0e-4, 2.0e-3}) {
        const double way_m = 0.02;
        const Pose from = at_depth(-0.01);
        const Pose to = at_depth(-0.01 + way_m);
        const double depth_m = -0.01 + way_m * sampler.find_first_touch(from, to, deepest_m);
        INFO(deepest_m << ": " << depth_m);
        CHECK(depth_m <= deepest_m + 0.01 * voxel_m);
        CHECK(depth_m >= deepest_m - FieldSampler::kNearTouch_voxels * voxel_m);
    }
    // Much too deep a limit would be none: it is three quarters of the band.
    const double free = sampler.find_first_touch(at_depth(-0.001), at_depth(0.015), 1.0);
    CHECK(-0.001 + 0.016 * free < 2.4 * voxel_m);
    CHECK(sampler.find_first_touch(at_depth(-0.001), at_depth(0.001), std::nan("")) < 1.0);
}

TEST_CASE("field sampling sweep: pressed again and again, fast or slowly, it does not creep in") {
    FieldSampler sampler = make_ball_on_box();
    const double voxel_m = 2.0 * kHalf_m / 55.98;
    for (const double step_voxels : {1.0e-4, 4.0e-4, 0.01, 0.3, 5.0}) {
        Pose at = at_depth(-0.2 * voxel_m);
        for (int i = 0; i < 3000; ++i) {
            Pose to = at;
            to.position.y() -= step_voxels * voxel_m;
            to.position.x() += 0.1 * step_voxels * voxel_m * (i % 2 == 0 ? 1.0 : -1.0);
            at = at_share(at, to, sampler.find_first_touch(at, to));
        }
        INFO(step_voxels);
        CHECK(kHalf_m + kBall_m - at.position.y() < 0.05 * voxel_m);
    }
}

TEST_CASE("field sampling sweep: a wall is not passed at 2 or 5 m/s from any distance or contact") {
    const double thickness_m = 1.0e-3;
    FieldSampler sampler =
        make_sampler(*make_box({0.1, thickness_m, 0.1}), 512, *make_sphere(2.0e-3, 8), 2000);
    const double touch_m = 0.5 * thickness_m + 2.0e-3;
    const double deepest_m = 2.0e-4;
    Random random(4);
    for (const double speed : {2.0, 5.0}) {
        for (int i = 0; i < 100; ++i) {
            const double start_m = touch_m + 1.0e-3 * random.uniform() * (i % 2) - 1.0e-4;
            const Pose from{{0.02 * random.uniform(), std::max(start_m, touch_m - deepest_m), 0.0},
                            random.turn(3.0)};
            const Vector3 way =
                1.0e-3 * speed * Vector3(random.uniform(), -1.0, random.uniform()).normalized();
            const Pose to{from.position + way, random.turn(0.01) * from.orientation};
            const double share = sampler.find_first_touch(from, to, deepest_m);
            CHECK(at_share(from, to, share).position.y() > touch_m - deepest_m - 2.0e-5);
        }
    }
}

TEST_CASE("field sampling sweep: deeper than the band, a tool may go out and along, no deeper") {
    FieldSampler sampler = make_ball_on_box();
    const double voxel_m = 2.0 * kHalf_m / 55.98;
    // Half of the ball lies deeper than three voxels, the field's band.
    const Pose from = at_depth(0.01);
    for (const double way_m : {0.5e-3, 4.0e-3, 0.015}) {
        const double share = sampler.find_first_touch(from, at_depth(0.01 + way_m));
        CHECK(share * way_m < 0.1 * voxel_m);
        CHECK(sampler.find_first_touch(from, at_depth(0.01 - way_m)) == 1.0);
    }
    CHECK(sampler.find_first_touch(from, at_depth(0.01, 5.0e-3)) == 1.0);
    // All of it beyond the band, from where nothing at all was seen.
    const Pose deep = at_depth(2.0 * kBall_m + 4.0 * voxel_m);
    CHECK(sampler.find_first_touch(deep, at_depth(2.0 * kBall_m + 5.0 * voxel_m)) < 0.2);
}

TEST_CASE(
    "field sampling sweep: a pose that is no number, no turn or too far away may go nowhere") {
    FieldSampler sampler = make_ball_on_box();
    const Pose here = at_depth(-0.01);
    Pose stretched = here;
    stretched.orientation.coeffs() *= 1.0e200;
    Pose flat = here;
    flat.orientation.coeffs().setZero();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Pose& broken : {Pose::at(Vector3::Constant(nan)), Pose::at({0.0, -1.0e18, 0.0}),
                               Pose::at({0.0, -1.0e300, 0.0}), stretched, flat}) {
        CHECK(sampler.find_first_touch(broken, here) == 0.0);
        CHECK(sampler.find_first_touch(here, broken) == 0.0);
        CHECK(sampler.step({}, broken).n_touching == 0);
    }
    // The longest way there is ends too, at the wall or short of it.
    CHECK(sampler.find_first_touch(Pose::at({0.0, 1.0e3, 0.0}), Pose::at({0.0, -1.0e3, 0.0})) <
          0.5);
}
