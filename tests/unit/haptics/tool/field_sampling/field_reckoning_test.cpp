#include "haptics/tool/field_sampling/last_look.h"
#include "haptics/tool/field_sampling/look_error.h"
#include "haptics/tool/field_sampling/look_time.h"
#include "haptics/tool/field_sampling/motion_clock.h"
#include "tests/support/field_parts.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numbers>
#include <vector>

namespace fulcrum {
namespace {

// How a look reckons with time, error and the look before it.
double now_us = 0.0;
FieldSamplingSettings make_measured(double budget_us) {
    now_us = 0.0;
    return {.budget_us = budget_us, .leaf_us = 1.0, .group_us = 0.1, .now_s = []() noexcept {
                return 1.0e-6 * now_us;
            }};
}

}  // namespace

TEST_CASE("motion clock: no point of the tool goes farther than it says, and it is no slower") {
    constexpr double kReach_m = 0.3;
    constexpr double kVoxel_m = 0.01;
    Random random(11);
    MotionClock clock;
    std::vector<Vector3> points;
    points.reserve(20);
    for (int i = 0; i < 20; ++i) {
        points.push_back(kReach_m * random.direction());
    }
    std::vector<double> went_voxels(points.size());
    Pose X_OT = Pose::at({5.0, 0.0, 0.0});
    clock.advance(X_OT, kReach_m, kVoxel_m);
    CHECK(clock.now() < 1.0e-6F);
    double turned_rad = 0.0;
    for (int i = 0; i < 200; ++i) {
        const Pose before = X_OT;
        const Quaternion turn = random.turn(0.1);
        X_OT = {X_OT.position + 0.002 * random.in_cube(), X_OT.orientation * turn};
        turned_rad += X_OT.orientation.angularDistance(before.orientation);
        clock.advance(X_OT, kReach_m, kVoxel_m);
        for (std::size_t p = 0; p < points.size(); ++p) {
            went_voxels[p] += (X_OT * points[p] - before * points[p]).norm() / kVoxel_m;
            REQUIRE(went_voxels[p] <= static_cast<double>(clock.now()));
        }
    }
    CHECK(clock.turned_rad() == Approx(turned_rad).epsilon(1.0e-3));  // 2 sin(phi / 2) for phi
    // The way alone is what it says, but for its rounding.
    const float before = clock.now();
    X_OT.position.y() += 7.0 * kVoxel_m;
    clock.advance(X_OT, kReach_m, kVoxel_m);
    CHECK(clock.now() - before == Approx(7.0).epsilon(1.0e-4));
}

TEST_CASE("motion clock: it is begun anew before single precision is too coarse") {
    MotionClock clock;
    Pose X_OT;
    clock.advance(X_OT, 1.0, 1.0);
    X_OT.position.x() = 4095.0;
    clock.advance(X_OT, 1.0, 1.0);
    CHECK_FALSE(clock.is_to_rebase());
    X_OT.position.x() = 4097.0;
    clock.advance(X_OT, 1.0, 1.0);
    CHECK(clock.is_to_rebase());
    clock.rebase();
    CHECK(clock.now() == 0.0F);
    X_OT.position.x() = 4100.0;
    clock.advance(X_OT, 1.0, 1.0);
    CHECK(clock.now() == Approx(3.0).epsilon(1.0e-5));
    // Turned by 100 rad in all, on the spot and with no reach.
    for (int i = 0; i < 101; ++i) {
        REQUIRE(clock.is_to_rebase() == (clock.turned_rad() > 100.0));
        X_OT.orientation = X_OT.orientation * Quaternion(AngleAxis(1.1, Vector3::UnitX()));
        clock.advance(X_OT, 0.0, 1.0);
    }
    CHECK(clock.is_to_rebase());
    clock.reset();
    clock.advance(Pose::at({9.0, 9.0, 9.0}), 1.0, 1.0);
    CHECK(clock.now() < 1.0e-6F);
}

TEST_CASE("look time: counted, a look has room for its budget less what it did, held and shares") {
    LookTime time(
        {.budget_us = 100.0, .clock = BudgetClock::counted, .leaf_us = 2.0, .group_us = 0.5});
    time.begin();
    CHECK(time.find_room(1.0) == 50);
    CHECK(time.find_room(0.5) == 25);
    time.work() = {.n_leaves = 10, .n_groups = 8, .n_sloped = 1};  // 20 + 4 + 4 x 2 us
    CHECK(time.elapsed_us() == Approx(32.0));
    CHECK(time.find_room(1.0) == 34);
    CHECK(time.find_room_to_open() == 27);  // 68 / 2.5
    CHECK(time.has_time_to_open(27));
    CHECK_FALSE(time.has_time_to_open(28));
    CHECK(time.find_slopes_stride(16) == 2);  // eight fit
    time.hold_for(4);
    CHECK(time.find_room(1.0) == 30);
    time.hold_for(0);
    time.set_share(0.5);
    CHECK(time.find_room(1.0) == 9);
    time.set_share(0.1);
    CHECK(time.find_left_us() == 0.0);
    // Part of a step, it has what that can spare, and tells it what it did.
    StepTime step(240.0, BudgetClock::counted);
    step.begin();
    time.set_share(1.0);
    time.begin_step(&step, 2);
    time.begin();
    CHECK(time.find_left_us() == Approx(240.0 / 6.0 / 2.0));
    time.work().n_leaves = 3;
    time.end();
    CHECK(step.elapsed_us() == Approx(6.0));
    CHECK(step.n_points() == 96);
    CHECK(LookTime({}).find_slopes_stride(1000) == 1);
}

TEST_CASE("look time: what things cost is learned quickly up and slowly down") {
    LookTime time(make_measured(100.0));
    time.begin();
    const auto find_cost_us = [&] {
        return time.find_left_us() / (static_cast<double>(time.find_room(1.0)) + 0.5);
    };
    CHECK(find_cost_us() == Approx(1.0).epsilon(0.02));
    for (int i = 0; i < 50; ++i) {
        time.learn_leaves(16.0 * 1.6, 16);  // and a quarter more: 2 us
    }
    CHECK(find_cost_us() == Approx(2.0).epsilon(0.02));
    time.learn_leaves(16.0 * 0.8, 16);
    CHECK(find_cost_us() == Approx(1.9).epsilon(0.02));
    time.learn_leaves(16.0 * 1.0e6, 16);  // interrupted: no more than twice what it is taken to be
    CHECK(find_cost_us() == Approx(1.9 * 1.2).epsilon(0.03));
}

TEST_CASE(
    "look time: a look that lost the processor does what it planned; one that was late ends "
    "earlier") {
    LookTime time(make_measured(100.0));
    time.begin();
    now_us = 10.0;
    CHECK(time.find_left_us() == Approx(90.0));
    CHECK(time.end_leaves(0.0, 16) == Approx(10.0));
    CHECK(time.find_left_us() == Approx(90.0));
    now_us = 1010.0;  // 16 leaves do not take a millisecond
    CHECK(time.end_leaves(10.0, 16) == Approx(1000.0));
    CHECK(time.find_left_us() == Approx(90.0));
    // Nor do they tell of themselves what is not theirs: late by 30 us, of which 5 count, and one more.
    now_us += 120.0;
    time.end();
    time.begin();
    CHECK(time.find_left_us() == Approx(100.0 - 6.0));
    now_us += 50.0;
    time.end();
    time.begin();
    CHECK(time.find_left_us() == Approx(100.0 - 6.0).epsilon(1.0e-4));
    CHECK(time.find_left_us() > 94.0);
}

TEST_CASE(
    "look error: a leaf that was left out may push with all its points, each as deep as may be") {
    const SampledPair pair(test::make_unit_box_field(32),
                           test::make_shell(*make_sphere(0.2, 16), 4000));
    const double voxel_m = pair.field->frame().voxel_m;
    const double slope = pair.field->slope_bound();
    for (const ForceAlong along : {ForceAlong::normals, ForceAlong::slopes}) {
        const FieldSamplingSettings settings{.stiffness_N_per_m = 50.0, .along = along};
        LookError error(pair, settings);
        LeafSums sums(pair, settings);
        error.begin();
        FieldTouch touch;
        error.tell(pair, sums, touch);
        CHECK(touch.bound_N == 0.0);
        CHECK(touch.error_N == 0.0);
        error.leave_out(pair, 0, 3, 0.5F);
        error.leave_out(pair, 1, 1, 0.25F);  // eight leaves
        error.leave_out(pair, 0, 4, -1.0F);  // by its motion it cannot be inside
        error.tell(pair, sums, touch);
        const double along_slope = along == ForceAlong::slopes ? slope : 1.0;
        const double deep_m = slope * voxel_m * (32.0 * 0.5 + 256.0 * 0.25);
        CHECK(touch.bound_N == Approx(50.0 * along_slope * deep_m));
        CHECK(touch.bound_Nm == Approx(pair.shell->reach_m() * touch.bound_N));
        CHECK(touch.error_N == touch.bound_N);
        CHECK(touch.n_left == 3);
        // Samples that told where to look: what they may have missed, half as deep as the deepest, or what closer looks moved.
        touch.deepest_m = 1.0e-4;
        error.set_miss({.points = 10.0});
        error.tell(pair, sums, touch);
        CHECK(touch.error_N == Approx(50.0 * along_slope * 0.5 * 1.0e-4 * 10.0));
        error.set_miss({.points = 10.0, .force_m = 0.02, .torque_m2 = 0.01});
        error.tell(pair, sums, touch);
        CHECK(touch.error_N == Approx(50.0 * 0.02));
        CHECK(touch.error_Nm == Approx(std::min(touch.bound_Nm, 50.0 * 0.01)));
        error.set_cut_short(true);
        error.tell(pair, sums, touch);
        CHECK(touch.error_N == touch.bound_N);
        // However far it may have gone, no deeper than anything is in the object.
        error.begin();
        error.leave_out(pair, 0, 0, 1.0e4F);
        error.tell(pair, sums, touch);
        const auto deepest =
            std::max_element(pair.field->depths().begin(), pair.field->depths().end());
        CHECK(touch.bound_N ==
              Approx(50.0 * along_slope * 32.0 * voxel_m * static_cast<double>(*deepest)));
    }
}

TEST_CASE("last look: told again at its poses; held for a look that was cut short, a step long") {
    const Pose here = Pose::at({1.0, 0.0, 0.0});
    const Pose there = Pose::at({2.0, 0.0, 0.0});
    LastLook last;
    CHECK_FALSE(last.is_known(here, there));
    FieldTouch touch;
    touch.wrench_W.force = {0.0, 3.0, 0.0};
    touch.n_touching = 5;
    last.begin_step();
    last.remember(here, there, touch, false);
    CHECK(last.is_known(here, there));
    CHECK_FALSE(last.is_known(here, here));
    // What left something out is known in its own step alone.
    touch.n_left = 2;
    last.remember(here, there, touch, true);
    CHECK(last.is_known(here, there));
    last.begin_step();
    CHECK_FALSE(last.is_known(here, there));
    // Turned with the object; off by all that is not what was taken.
    const Pose turned{here.position,
                      Quaternion(AngleAxis(0.5 * std::numbers::pi, Vector3::UnitX()))};
    FieldTouch cut;
    cut.n_left = 1;
    cut.n_leaves = 1;
    FieldTouch held = cut;
    last.hold(turned, false, held);
    CHECK(held.n_touching == 0);
    last.hold(turned, true, held);
    CHECK(held.n_touching == 5);
    CHECK((held.wrench_W.force - Vector3(0.0, 0.0, 3.0)).norm() < 1.0e-12);
    CHECK(held.bound_N == Approx(3.0));
    CHECK(held.error_N == held.bound_N);
    last.begin_step();
    held = cut;
    last.hold(turned, true, held);
    CHECK(held.n_touching == 0);
    last.begin_step();
    last.hold(turned, true, held);
    CHECK(held.n_touching == 5);
    last.forget();
    CHECK_FALSE(last.is_known(here, there));
}

}  // namespace fulcrum
