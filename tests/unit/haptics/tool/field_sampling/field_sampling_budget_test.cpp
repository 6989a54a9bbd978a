// Budgets of time, on a counted clock, so that each run is the same.
#include "haptics/tool/field_sampling/field_sampler.h"
#include "tests/support/field_parts.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace fulcrum;
using test::make_shell;

namespace {

constexpr double kLeaf_us = 0.13;
constexpr double kGroup_us = 0.04;
constexpr double kRounding_us = 1.0e-6;
constexpr double kTimes = 25.0;  // the error said, at the median, at most: as the header has it

FieldSampler::Field bumpy() {
    static const auto kField = std::make_shared<const DistanceField>(test::build_bumpy_field(128));
    return kField;
}

FieldSampler::Field box() {
    static const FieldSampler::Field kField = test::make_unit_box_field(64);
    return kField;
}

// A plate of rows of points; how far each lies below it.
template <class Down>
FieldSampler::Shell make_plate(Down down_m) {
    return make_shell(test::make_point_rows(
        200, 0.8, [&](int row, int column) { return -down_m(200 * row + column); }));
}

FieldSampler::Shell ball(int n_points = 20000) {
    static const TriangleMesh kBall = make_bumpy_sphere(1.0, 16, 0.03, 9.0).value();
    static const FieldSampler::Shell kShell = make_shell(kBall, 20000);
    return n_points == 20000 ? kShell : make_shell(kBall, n_points);
}

FieldSampler make(const FieldSampler::Field& field, const FieldSampler::Shell& shell,
                  double budget_us, ForceAlong along = ForceAlong::normals,
                  double leaf_us = kLeaf_us, double group_us = kGroup_us) {
    return FieldSampler::build(field, shell,
                               {.along = along,
                                .budget_us = budget_us,
                                .clock = BudgetClock::counted,
                                .leaf_us = leaf_us,
                                .group_us = group_us})
        .value();
}

// A clock on which a microsecond goes by from one look to the next.
double count_a_microsecond_s() noexcept {
    static double now_s = 0.0;
    return now_s += 1.0e-6;
}

// Derivatives of a leaf count as sixteen, by slopes as four.
double cost_us(const FieldTouch& touch, std::int64_t slopes_leaves = 16) {
    return static_cast<double>(touch.n_leaves + slopes_leaves * touch.n_sloped) * kLeaf_us +
           static_cast<double>(touch.n_groups) * kGroup_us;
}

struct Off {
    double force_N, torque_Nm;
};
Off compare(const FieldTouch& some, const FieldTouch& all) {
    return {(some.wrench_W.force - all.wrench_W.force).norm(),
            (some.wrench_W.torque - all.wrench_W.torque).norm()};
}

// No farther off than the bound; by so much of the force single precision may be.
void check_bounded(const FieldTouch& some, const FieldTouch& all, double rounding = 0.0) {
    const Off off = compare(some, all);
    const double rounding_N = rounding * all.wrench_W.force.norm();
    CHECK(off.force_N <= some.bound_N + rounding_N);
    CHECK(off.torque_Nm <= some.bound_Nm + rounding_N);
}

}  // namespace

TEST_CASE("field sampling budget: kept, and exact where it is enough") {
    for (const ForceAlong along : {ForceAlong::normals, ForceAlong::slopes}) {
        FieldSampler all = make(bumpy(), ball(), 0.0, along);
        FieldSampler small = make(bumpy(), ball(), 5.0, along);
        FieldSampler ample = make(bumpy(), ball(), 1.0e4, along);
        // The balls lie in each other: everything is near.
        Random random(8);
        for (int i = 0; i < 100; ++i) {
            const Pose X_WT{0.02 * random.in_cube(), random.turn(0.5)};
            const FieldTouch exact = all.step({}, X_WT);
            const FieldTouch full = ample.step({}, X_WT);
            CHECK(full.wrench_W.force == exact.wrench_W.force);
            CHECK(full.wrench_W.torque == exact.wrench_W.torque);
            CHECK(full.error_N == 0.0);
            CHECK(full.error_Nm == 0.0);
            CHECK(full.n_left == 0);
            const FieldTouch some = small.step({}, X_WT);
            CHECK(cost_us(some) <= 5.0 + kRounding_us);
            CHECK(some.n_left > 0);
        }
    }
}

TEST_CASE("field sampling budget: where many touch, samples stand for all to 2 %") {
    FieldSampler all = make(bumpy(), ball(), 0.0);
    FieldSampler small = make(bumpy(), ball(), 20.0);
    Random random(8);
    for (int i = 0; i < 200; ++i) {
        const Pose X_WT{0.06 * random.direction(), random.turn(0.5)};
        const FieldTouch exact = all.step({}, X_WT);
        const FieldTouch some = small.step({}, X_WT);
        CHECK(cost_us(some) <= 20.0 + kRounding_us);
        CHECK(some.weight > 1);
        REQUIRE(some.n_touching >= 150 * some.weight);
        const Off off = compare(some, exact);
        CHECK(off.force_N < 0.02 * exact.wrench_W.force.norm());
        CHECK(off.force_N <= some.error_N);
        CHECK(off.torque_Nm <= some.error_Nm);
        CHECK(some.error_N <= some.bound_N);
        CHECK(some.error_Nm <= some.bound_Nm);
        CHECK(static_cast<double>(some.n_touching) ==
              Approx(static_cast<double>(exact.n_touching)).epsilon(0.1));
    }
}

TEST_CASE(
    "field sampling budget: in local contact the error is never more than said, nor much less") {
    for (const ForceAlong along : {ForceAlong::normals, ForceAlong::slopes}) {
        FieldSampler all = make(bumpy(), ball(), 0.0, along);
        FieldSampler small = make(bumpy(), ball(), 5.0, along);
        Wanderer wanderer(4);
        Random random(5);
        std::vector<double> times_force;
        std::vector<double> times_torque;
        for (int i = 0; i < 600; ++i) {
            const Pose X_WT{1.9 * wanderer.next(), random.turn(0.001)};
            const FieldTouch exact = all.step({}, X_WT);
            const FieldTouch some = small.step({}, X_WT);
            const Off off = compare(some, exact);
            CHECK(cost_us(some) <= 5.0 + kRounding_us);
            // Nothing is off but single precision where nothing was left out.
            const double rounding_N = 1.0e-6 * exact.wrench_W.force.norm();
            CHECK(off.force_N <= some.error_N + rounding_N);
            CHECK(off.torque_Nm <= some.error_Nm + rounding_N);
            check_bounded(some, exact, 1.0e-6);
            if (some.weight > 1) {
                CHECK(some.error_N < 0.1 * some.bound_N);
                times_force.push_back(some.error_N / off.force_N);
                times_torque.push_back(some.error_Nm / off.torque_Nm);
            }
        }
        REQUIRE(times_force.size() > 300);
        for (std::vector<double>* const times : {&times_force, &times_torque}) {
            std::sort(times->begin(), times->end());
            CHECK((*times)[times->size() / 2] < kTimes);
        }
    }
}

TEST_CASE("field sampling budget: a lone tip among points that are near weighs what it weighs") {
    const double voxel_m = box()->frame().voxel_m;
    for (const int tip : {0, 7777, 20100, 39999}) {
        const auto plate = make_plate([&](int i) { return i == tip ? 1.3 * voxel_m : 0.0; });
        FieldSampler all = make(box(), plate, 0.0);
        FieldSampler small = make(box(), plate, 10.0);
        FieldTouch some;
        int n_frames = 0;  // until it is found
        for (int i = 0; i < 400; ++i) {
            const Pose X_WT = Pose::at({0.0, 0.5 + 0.3 * voxel_m, 5.0e-6 * i});
            const FieldTouch exact = all.step({}, X_WT);
            REQUIRE(exact.n_touching == 1);
            some = small.step({}, X_WT);
            CHECK(cost_us(some) <= 10.0 + kRounding_us);
            // Nothing, or what it is; once found it is kept.
            const bool is_found = some.n_touching == 1;
            n_frames += is_found ? 0 : 1;
            CHECK(is_found == (i >= n_frames));
            CHECK(some.wrench_W.force.y() ==
                  Approx(is_found ? exact.wrench_W.force.y() : 0.0).epsilon(1.0e-5));
            CHECK(compare(some, exact).force_N <= some.error_N + 1.0e-6);
        }
        CHECK(n_frames < 5);
        // All the others are known to be free by now.
        CHECK(some.error_N == 0.0);
    }
}

TEST_CASE("field sampling budget: nothing touches, but what was not looked at is owned up to") {
    // Of the plate's middle: no point is nearer than 2 m, none farther than 2.9.
    const Vector3 arm(2.4, 0.0, 0.0);
    const Pointshell plate = test::make_point_rows(200, 0.8, [](int, int) { return 0.0; });
    FieldSampler small = make(box(), make_shell(make_moved(plate, Pose::at(arm))), 5.0);
    const Pose X_WT = Pose::at({-arm.x(), 0.5 + 0.3 * box()->frame().voxel_m, 0.0});
    FieldTouch touch = small.step({}, X_WT);
    CHECK(touch.n_touching == 0);
    CHECK(touch.wrench_W.force == Vector3::Zero());
    CHECK(touch.error_N > 0.0);
    CHECK(touch.error_Nm > 2.0 * touch.error_N);
    CHECK(touch.error_Nm < 2.9 * touch.error_N);
    for (int i = 0; i < 400; ++i) {
        touch = small.step({}, X_WT);
    }
    CHECK(touch.error_N == 0.0);
}

TEST_CASE("field sampling budget: the clock ends a step that takes leaves to be cheaper than any") {
    const FieldSampler::Shell shell = ball(200000);
    FieldSampler hasty =
        FieldSampler::build(bumpy(), shell, {.budget_us = 200.0, .leaf_us = 0.01, .group_us = 0.01})
            .value();
    const FieldTouch touch = hasty.step({}, Pose::at({0.02, 0.01, 0.0}));
    CHECK(touch.n_leaves < static_cast<std::int64_t>(shell->n_leaves()));
    CHECK(touch.n_left > 0);
}

TEST_CASE(
    "field sampling budget: the machine's clock is kept too, and what it leaves out is said") {
    FieldSampler all = make(bumpy(), ball(), 0.0);
    FieldSampler small = FieldSampler::build(bumpy(), ball(), {.budget_us = 5.0}).value();
    Random random(8);
    for (int i = 0; i < 50; ++i) {
        const Pose X_WT{0.06 * random.direction(), random.turn(0.5)};
        const FieldTouch exact = all.step({}, X_WT);
        const FieldTouch some = small.step({}, X_WT);
        CHECK(some.n_leaves < exact.n_leaves);
        CHECK(some.n_left > 0);
        check_bounded(some, exact);
    }
}

TEST_CASE("field sampling budget: kept whatever the tool did before, still, slow or jumping") {
    FieldSampler all = make(bumpy(), ball(), 0.0);
    for (const double budget_us : {5.0, 20.0, 60.0, 90.0}) {
        FieldSampler some = make(bumpy(), ball(), budget_us);
        Wanderer wanderer(4, 0.05);
        Random random(11);
        Pose X_WT;
        for (int i = 0; i < 400; ++i) {
            // Rest, in which what touches becomes known; then a jump, near or far.
            if (i % 20 == 0) {
                X_WT = {(i % 40 == 0 ? 1.9 : 0.05) * wanderer.next(), random.turn(0.5)};
            } else if (i % 20 > 15) {
                X_WT.position += 0.01 * random.in_cube();
            }
            const FieldTouch touch = some.step({}, X_WT);
            CHECK(cost_us(touch) <= budget_us + kRounding_us);
            check_bounded(touch, all.step({}, X_WT), 1.0e-6);
        }
    }
}

TEST_CASE("field sampling budget: derivatives have their part of it, and stand for all") {
    for (const ForceAlong along : {ForceAlong::normals, ForceAlong::slopes}) {
        FieldSampler all = make(bumpy(), ball(), 0.0, along);
        const std::int64_t slopes_leaves = along == ForceAlong::slopes ? 4 : 16;
        const double some_us = along == ForceAlong::slopes ? 50.0 : 100.0;
        FieldSampler some = make(bumpy(), ball(), some_us, along);
        FieldSampler few = make(bumpy(), ball(), 5.0, along);
        Random random(8);
        for (int i = 0; i < 40; ++i) {
            const Pose X_WT{0.06 * random.direction(), random.turn(0.5)};
            Matrix6 exact = Matrix6::Zero();
            Matrix6 about = Matrix6::Zero();
            Matrix6 roughly = Matrix6::Zero();
            const FieldTouch touch = all.step_linearised({}, X_WT, exact);
            CHECK(touch.n_sloped > 30);
            const FieldTouch fewer = some.step_linearised({}, X_WT, about);
            CHECK(cost_us(fewer, slopes_leaves) <= some_us + kRounding_us);
            CHECK(fewer.n_sloped > 10);
            CHECK(fewer.n_sloped < touch.n_sloped);
            // As a stiffness against shifts, of a tool that is touched all round.
            const Matrix3 off = about.topLeftCorner<3, 3>() - exact.topLeftCorner<3, 3>();
            CHECK(off.norm() < 0.3 * exact.topLeftCorner<3, 3>().norm());
            CHECK(cost_us(few.step_linearised({}, X_WT, roughly), slopes_leaves) <=
                  5.0 + kRounding_us);
        }
    }
}

TEST_CASE("field sampling budget: a cost thought far too high comes down by itself") {
    const auto make_thinking = [](double leaf_us, double budget_us) {
        return FieldSampler::build(
                   bumpy(), ball(),
                   {.budget_us = budget_us, .leaf_us = leaf_us, .now_s = &count_a_microsecond_s})
            .value();
    };
    FieldSampler wary = make_thinking(10.0, 50.0);
    FieldSampler never = make_thinking(10.0, 9.0);
    FieldSampler eager = make_thinking(0.1, 50.0);
    const Pose X_WT = Pose::at({0.05, 0.01, 0.0});
    std::int64_t n_wary = 0;
    std::int64_t n_eager = 0;
    std::int64_t n_never = 0;
    for (int i = 0; i < 400; ++i) {
        n_wary = wary.step({}, X_WT).n_leaves;
        n_eager = eager.step({}, X_WT).n_leaves;
        n_never = std::max(n_never, never.step({}, X_WT).n_leaves);
    }
    CAPTURE(n_wary, n_eager, n_never);
    CHECK(n_eager > 0);
    CHECK(10 * n_wary > 9 * n_eager);
    // Not even one leaf fits, as long as it is thought to cost that much.
    CHECK(n_never > 0);
}

TEST_CASE("field sampling budget: the bound holds deeper than the band, and where pushes cancel") {
    const FieldSampler::Shell points = make_shell(make_sphere(0.2, 16).value(), 20000);
    for (const ForceAlong along : {ForceAlong::normals, ForceAlong::slopes}) {
        FieldSampler all = make(box(), points, 0.0, along);
        Random random(3);
        for (const double depth_m : {0.02, 0.06, 0.2, 0.45, 0.69}) {
            // So dear that none is looked at: the bound alone must say what is missing.
            FieldSampler some = make(box(), points, 5.0, along, 10.0, 0.01);
            for (int i = 0; i < 5; ++i) {
                const Pose X_WT{{0.01 * i, 0.7 - depth_m, 0.0}, random.turn(0.5)};
                const FieldTouch exact = all.step({}, X_WT);
                const FieldTouch touch = some.step({}, X_WT);
                REQUIRE(exact.n_touching > 0);
                INFO(depth_m);
                check_bounded(touch, exact);
            }
        }
    }
    // A slot that closes on a box from both sides.
    const double half_m = 0.5 - 0.3 * box()->frame().voxel_m;
    Pointshell slot = test::make_point_rows(160, 0.8, [&](int, int) { return half_m; });
    for (std::size_t i = 0; i < 160 * 160; ++i) {
        slot.add({slot.x_m[i], -half_m, slot.z_m[i]}, -Vector3::UnitY());
    }
    FieldSampler some = make(box(), make_shell(slot), 20.0);
    const FieldTouch touch = some.step({}, Pose::at({0.003, 0.0, 0.002}));
    REQUIRE(touch.weight > 1);
    const double stiffness_N_per_m = some.settings().stiffness_N_per_m;
    const auto weight = static_cast<double>(touch.weight);
    CHECK(touch.error_N >= 0.5 * weight * stiffness_N_per_m * touch.deepest_m);
}
