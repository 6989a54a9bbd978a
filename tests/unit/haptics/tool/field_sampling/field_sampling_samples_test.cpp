#include "haptics/math/rotation.h"
#include "haptics/tool/field_sampling/field_sampler.h"
#include "haptics/tool/field_sampling/field_sampling_settings.h"
#include "haptics/tool/field_sampling/field_sweep.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/field_parts.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/refused.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kLeaf_us = 0.2;
constexpr double kGroup_us = 0.04;

FieldSampler make(const FieldSampler::Field& field, const FieldSampler::Shell& shell,
                  double budget_us) {
    return FieldSampler::build(field, shell,
                               {.budget_us = budget_us,
                                .clock = BudgetClock::counted,
                                .leaf_us = kLeaf_us,
                                .group_us = kGroup_us})
        .value();
}

double cost_us(const FieldTouch& touch) {
    return static_cast<double>(touch.n_leaves) * kLeaf_us +
           static_cast<double>(touch.n_groups) * kGroup_us;
}

FieldSampler::Field socket() {
    static const FieldSampler::Field kField = test::make_field(
        make_hollow(*make_sphere(1.2, 24), *make_bumpy_sphere(1.0, 24, 0.02, 9.0)).value(), 128);
    return kField;
}

// What fills it but for a voxel.
FieldSampler::Shell plug() {
    static const FieldSampler::Shell kShell = test::make_shell(
        *make_bumpy_sphere(1.0 - socket()->frame().voxel_m, 24, 0.02, 9.0), 100000);
    return kShell;
}

// Pressed to a side that wanders.
std::vector<Pose> make_way(double step_voxels, int n) {
    const double voxel_m = socket()->frame().voxel_m;
    Wanderer wanderer(5, step_voxels);
    std::vector<Pose> way;
    for (int i = 0; i < n; ++i) {
        const Quaternion turn(AngleAxis(1.0e-3 * std::sin(0.1 * i), Vector3::UnitY()));
        way.push_back({1.02 * voxel_m * wanderer.next(), turn});
    }
    return way;
}

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

// What samples tell a budget of time, on a counted clock: in a socket nearly all points are near, and few touch.

TEST_CASE("field sampling samples: in a socket the force is right to 1 %, and the error is said") {
    constexpr double kBudget_us = 60.0;
    for (const double step_voxels : {0.1, 0.3}) {
        FieldSampler all = make(socket(), plug(), 0.0);
        FieldSampler some = make(socket(), plug(), kBudget_us);
        FieldSampler again = make(socket(), plug(), kBudget_us);
        std::vector<double> off;
        for (const Pose& X_WT : make_way(step_voxels, 300)) {
            const FieldTouch exact = all.step({}, X_WT);
            const FieldTouch touch = some.step({}, X_WT);
            CHECK(cost_us(touch) <= kBudget_us + 1.0e-6);
            const double force_N = exact.wrench_W.force.norm();
            const double off_N = (touch.wrench_W.force - exact.wrench_W.force).norm();
            const double off_Nm = (touch.wrench_W.torque - exact.wrench_W.torque).norm();
            CHECK(off_N <= touch.error_N + 1.0e-6 * force_N);
            CHECK(off_Nm <= touch.error_Nm + 1.0e-6 * force_N);
            CHECK(touch.error_N <= touch.bound_N);
            if (touch.n_left > 0 && touch.n_touching >= 150 * touch.weight) {
                off.push_back(off_N / force_N);
            }
            const FieldTouch same = again.step({}, X_WT);
            CHECK(same.wrench_W.force == touch.wrench_W.force);
            CHECK(same.wrench_W.torque == touch.wrench_W.torque);
            CHECK(same.error_N == touch.error_N);
        }
        REQUIRE(off.size() > 280);
        std::sort(off.begin(), off.end());
        INFO(step_voxels);
        CAPTURE(off[off.size() / 2], off[off.size() * 99 / 100], off.back());
        CHECK(off[off.size() * 99 / 100] < 0.01);
    }
}

TEST_CASE("field sampling samples: a lone tip that was found is kept while samples see another") {
    const FieldSampler::Field box = test::make_unit_box_field(64);
    const double voxel_m = box->frame().voxel_m;
    const auto plate = test::make_shell(test::make_point_rows(200, 0.8, [&](int row, int column) {
        const bool is_tip = 200 * row + column == 7777;
        const bool is_patch = row >= 150 && row < 170 && column >= 150 && column < 170;
        return -voxel_m * (is_tip ? 1.3 : is_patch ? 0.6 : 0.0);
    }));
    FieldSampler all = make(box, plate, 0.0);
    FieldSampler some = make(box, plate, 15.0);
    const auto at = [&](double up_voxels) {
        return Pose::at({0.0, 0.5 + up_voxels * voxel_m, 0.0});
    };
    // The tip alone, until it is found.
    FieldTouch touch;
    for (int i = 0; i < 20; ++i) {
        touch = some.step({}, at(1.0));
    }
    REQUIRE(touch.n_touching == 1);
    // Now the patch touches too.
    for (int i = 0; i < 20; ++i) {
        const Pose X_WT = at(0.5 - 0.001 * i);
        const FieldTouch exact = all.step({}, X_WT);
        touch = some.step({}, X_WT);
        REQUIRE(exact.n_touching == 401);
        CHECK(touch.n_touching == exact.n_touching);
        CHECK(touch.weight == 1);
        CHECK(touch.wrench_W.force.y() == Approx(exact.wrench_W.force.y()).epsilon(1.0e-5));
    }
}

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

TEST_CASE("field sampling sweep: out and along, no deeper; what is no pose goes nowhere") {
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
    sampler = make_ball_on_box();
    const Pose here = at_depth(-0.01);
    Pose stretched = here;
    stretched.orientation.coeffs() *= 1.0e200;
    Pose flat = here;
    flat.orientation.coeffs().setZero();
    for (const Pose& broken : {Pose::at(Vector3::Constant(kNan)), Pose::at({0.0, -1.0e18, 0.0}),
                               Pose::at({0.0, -1.0e300, 0.0}), stretched, flat}) {
        CHECK(sampler.find_first_touch(broken, here) == 0.0);
        CHECK(sampler.find_first_touch(here, broken) == 0.0);
        CHECK(sampler.step({}, broken).n_touching == 0);
    }
    // The longest way there is ends too, at the wall or short of it.
    CHECK(sampler.find_first_touch(Pose::at({0.0, 1.0e3, 0.0}), Pose::at({0.0, -1.0e3, 0.0})) <
          0.5);
}

TEST_CASE("field sampling build: settings out of range and missing parts are refused") {
    check_refused(
        FieldSamplingSettings{.budget_us = 100.0},
        {[](auto& s) { s.stiffness_N_per_m = -1.0; },
         [](auto& s) { s.stiffness_N_per_m = std::nan(""); }, [](auto& s) { s.budget_us = 1.0; },
         [](auto& s) { s.budget_us = std::nan(""); }, [](auto& s) { s.leaf_us = 0.0; },
         [](auto& s) { s.group_us = 0.0; }, [](auto& s) { s.mode = SamplingMode::brute_force; },
         [](auto& s) { s.mode = SamplingMode::tree; }});
    CHECK(validate(FieldSamplingSettings{}));
    const TriangleMesh mesh = *make_sphere(1.0, 4);
    const auto field = test::make_field(mesh, 32);
    const auto shell = test::make_shell(mesh, 50);
    CHECK_FALSE(FieldSampler::build(nullptr, shell));
    CHECK_FALSE(FieldSampler::build(field, nullptr));
    CHECK_FALSE(FieldSampler::build(field, shell, {.leaf_us = -1.0}));
    const auto sampler = FieldSampler::build(field, shell);
    REQUIRE(sampler);
    CHECK(sampler->memory_bytes() > 0);
}
