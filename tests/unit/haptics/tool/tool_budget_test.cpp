// A budget of time for a tool's step, on a counted clock, so that each run is the same.
#include "haptics/tool/voxel_tool.h"
#include "tests/support/field_parts.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kLeaf_us = 0.13;
constexpr double kGroup_us = 0.04;
constexpr double kDt_s = 1.0e-3;
constexpr double kTop_m = 0.02;
constexpr double kPlate_m = 0.06;     // a side of what lies flat
constexpr double kThick_m = 0.01;     // of it
constexpr double kRounding = 1.0e-6;  // single precision

FieldSampler::Field block() {
    static const FieldSampler::Field kField =
        test::make_field(make_box({0.1, 2.0 * kTop_m, 0.1}).value(), 96);
    return kField;
}

FieldSampler::Shell plate() {
    static const FieldSampler::Shell kShell =
        test::make_shell(make_box({kPlate_m, kThick_m, kPlate_m}).value(), 20000);
    return kShell;
}

FieldSamplingSettings make_sampling(double budget_us) {
    return {.stiffness_N_per_m = 20.0,
            .budget_us = budget_us,
            .clock = BudgetClock::counted,
            .leaf_us = kLeaf_us,
            .group_us = kGroup_us};
}

FieldSampler make_sampler(double budget_us) {
    return FieldSampler::build(block(), plate(), make_sampling(budget_us)).value();
}

VoxelToolSettings make_settings(double budget_us) {
    VoxelToolSettings settings;
    settings.coupling.shift.stiffness_N_per_m = 500.0;
    settings.coupling.turn.stiffness_Nm_per_rad = 1.0;
    settings.clamped_at_half_voxel = false;
    settings.inertia.mass_kg = 0.05;
    settings.inertia.moments_kg_m2 = {2.0e-5, 3.0e-5, 2.0e-5};
    settings.budget_us = budget_us;
    settings.clock = BudgetClock::counted;
    return settings;
}

FieldTool make_plate(const VoxelToolSettings& settings) {
    return FieldTool::build({block(), plate(), make_sampling(0.0)}, settings).value();
}

// Flat on the block's top, that much into it.
Pose lie(double depth_m) {
    return Pose::at({0.001, kTop_m + 0.5 * kThick_m - depth_m, -0.002});
}

Vector3 off(const FieldTouch& some, const FieldTouch& all) {
    return some.wrench_W.force - all.wrench_W.force;
}

}  // namespace

TEST_CASE("tool budget: the looks of a step take no more than its time, however many they are") {
    for (const double budget_us : {20.0, 60.0, 200.0}) {
        FieldSampler sampler = make_sampler(budget_us);
        StepTime time(budget_us, BudgetClock::counted);
        Random random(5);
        int n_full = 0;
        for (int step = 0; step < 60; ++step) {
            time.begin();
            sampler.begin_step(&time);
            const Pose X_WT{lie(3.0e-4).position + 2.0e-4 * random.in_cube(), random.turn(0.005)};
            // A solver that never asks whether there is time.
            for (int look = 0; look < 12; ++look) {
                const Pose X_look{X_WT.position + 1.0e-5 * random.in_cube(), X_WT.orientation};
                Matrix6 slopes = Matrix6::Zero();
                (void)(look % 2 == 0 ? sampler.step_linearised({}, X_look, slopes)
                                     : sampler.step({}, X_look));
            }
            // Whatever the time, the topmost group is asked, and of what touches one leaf's derivatives are taken.
            const double least_us = 12.0 * kGroup_us + 6.0 * 16.0 * kLeaf_us;
            CHECK(time.elapsed_us() <= budget_us + least_us);
            n_full += time.elapsed_us() > 0.5 * budget_us ? 1 : 0;
            sampler.begin_step(nullptr);
        }
        CHECK(n_full > 30);
    }
}

TEST_CASE("tool budget: within a step the force follows the pose alone") {
    FieldSampler all = make_sampler(0.0);
    for (const double budget_us : {30.0, 100.0}) {
        FieldSampler sampler = make_sampler(budget_us);
        StepTime time(budget_us, BudgetClock::counted);
        Random random(6);
        int n_left = 0;
        for (int step = 0; step < 40; ++step) {
            time.begin();
            sampler.begin_step(&time);
            const Pose first{lie(1.0e-4).position, random.turn(0.003)};
            const Pose second{first.position + 2.0e-5 * random.in_cube(), random.turn(0.003)};
            const FieldTouch here = sampler.step({}, first);
            const FieldTouch there = sampler.step({}, second);
            const FieldTouch again = sampler.step({}, first);
            CHECK((again.wrench_W.force - here.wrench_W.force).norm() <=
                  kRounding * here.wrench_W.force.norm());
            CHECK(there.weight == here.weight);
            n_left += here.n_left > 0 ? 1 : 0;
            // What is said holds at each.
            for (const auto& [pose, touch] :
                 {std::pair(first, here), std::pair(second, there), std::pair(first, again)}) {
                const FieldTouch exact = all.step({}, pose);
                const double rounding_N = kRounding * exact.wrench_W.force.norm();
                CHECK(off(touch, exact).norm() <= touch.error_N + rounding_N);
                CHECK(off(touch, exact).norm() <= touch.bound_N + rounding_N);
            }
            sampler.begin_step(nullptr);
        }
        CHECK(n_left > 30);
    }
}

TEST_CASE("tool budget: enough time changes nothing; several objects share one step's time") {
    FieldTool endless = make_plate(make_settings(0.0));
    FieldTool ample = make_plate(make_settings(1.0e5));
    endless.place(lie(-1.0e-3));
    ample.place(lie(-1.0e-3));
    for (int i = 1; i <= 120; ++i) {
        const MovingFrame hand{lie(-1.0e-3 + 2.0e-5 * i), {}};
        const VoxelToolResult exact = endless.step(hand, {}, i * kDt_s, kDt_s);
        const VoxelToolResult result = ample.step(hand, {}, i * kDt_s, kDt_s);
        REQUIRE(result.felt_W.force == exact.felt_W.force);
        REQUIRE(result.felt_W.torque == exact.felt_W.torque);
        REQUIRE(ample.state().pose_W.position == endless.state().pose_W.position);
        CHECK(result.effort.in_time);
        CHECK(result.effort.error_N == 0.0);
        CHECK(result.effort.n_points == exact.effort.n_points);
        CHECK(result.effort.n_looks == exact.effort.n_looks);
    }
    VoxelToolSettings settings = make_settings(60.0);
    const FieldSamplingPlan plan{block(), plate(), make_sampling(0.0)};
    FieldTool tool = FieldTool::build({plan, plan, plan}, settings).value();
    tool.place(lie(-2.0e-4));
    // Three blocks in one place.
    const std::vector<MovingFrame> objects(3);
    bool has_touched = false;
    for (int i = 1; i <= 200; ++i) {
        const ToolFelt felt =
            tool.move({lie(std::min(1.0e-5 * i - 2.0e-4, 1.0e-3)), {}}, objects, i * kDt_s, kDt_s);
        CHECK(static_cast<double>(felt.effort.n_points) / 32.0 * kLeaf_us <= 60.0);
        has_touched = has_touched || tool.touches()[2].touches;
    }
    CHECK(has_touched);
    CHECK(tool.touches()[0].error_N > 0.0);
    CHECK(tool.touches()[2].error_N > 0.0);
}

TEST_CASE(
    "tool budget: a tool that lies flat on many points ends each step in time and stays calm") {
    // A look at all that touch takes 30 us and its derivatives 500; of the whole step 80 are given.
    constexpr double kBudget_us = 80.0;
    for (const ToolMass mass : {ToolMass::massive, ToolMass::massless}) {
        VoxelToolSettings settings = make_settings(kBudget_us);
        settings.mass = mass;
        FieldTool tool = make_plate(settings);
        FieldSampler all = make_sampler(0.0);
        tool.place(lie(-5.0e-4));
        std::int64_t most_points = 0;
        int n_inexact = 0;
        for (int i = 1; i <= 400; ++i) {
            const MovingFrame hand{lie(std::min(2.0e-5 * i - 5.0e-4, 2.0e-3)), {}};
            const VoxelToolResult result = tool.step(hand, {}, i * kDt_s, kDt_s);
            REQUIRE(result.moved);
            most_points = std::max(most_points, result.effort.n_points);
            n_inexact += result.effort.error_N > 0.0 ? 1 : 0;
            const FieldTouch exact = all.step({}, tool.state().pose_W);
            const double off_N = (result.contact.wrench_W.force - exact.wrench_W.force).norm();
            CHECK(off_N <= result.effort.error_N + kRounding * exact.wrench_W.force.norm());
            CHECK(result.effort.error_N == result.contact.error_N);
        }
        CHECK(n_inexact > 100);
        CHECK(static_cast<double>(most_points) / 32.0 * kLeaf_us <= kBudget_us);
        // Pressed 2 mm in by 500 N/m, held by the points, upright and at rest.
        const MovingFrame hand{lie(2.0e-3), {}};
        const Pose rested = tool.state().pose_W;
        for (int i = 401; i <= 600; ++i) {
            const VoxelToolResult result = tool.step(hand, {}, i * kDt_s, kDt_s);
            CHECK((tool.state().pose_W.position - rested.position).norm() < 2.0e-5);
            CHECK(tool.state().pose_W.orientation.angularDistance(rested.orientation) < 2.0e-3);
            CHECK(result.felt_W.force.y() == Approx(1.0).epsilon(0.1));
        }
    }
}

TEST_CASE("tool budget: a look that was cut short tells the last force, a step long") {
    FieldSampler sampler = make_sampler(1000.0);
    const auto look = [&](double budget_us, const Pose& X_WO) {
        StepTime time(budget_us, BudgetClock::counted);
        time.begin();
        sampler.begin_step(&time);
        const FieldTouch touch = sampler.step(X_WO, X_WO * lie(0.0006));
        sampler.begin_step(nullptr);
        return touch;
    };
    constexpr double kPlenty_us = 1.0e4;
    constexpr double kNone_us = 1.0e-3;
    const FieldTouch first = look(kPlenty_us, Pose{});
    REQUIRE(first.n_left == 0);
    REQUIRE(first.wrench_W.force.y() > 1.0);
    // All has turned and moved since: the force turns along.
    const Pose X_WO{{0.3, -0.1, 0.2}, Quaternion(AngleAxis(0.8, Vector3(1.0, 2.0, -2.0) / 3.0))};
    const FieldTouch all = look(kPlenty_us, X_WO);
    (void)look(kPlenty_us, Pose{});
    const FieldTouch held = look(kNone_us, X_WO);
    CHECK(held.n_left > 0);
    CHECK(held.n_touching == first.n_touching);
    CHECK(off(held, all).norm() <= kRounding * all.wrench_W.force.norm());
    CHECK((held.wrench_W.torque - all.wrench_W.torque).norm() <=
          kRounding * all.wrench_W.force.norm() * plate()->reach_m());
    CHECK(held.error_N >= all.wrench_W.force.norm());
    // Twice in a row it says what it knows: nothing, and that it may be off.
    const FieldTouch again = look(kNone_us, X_WO);
    CHECK(again.n_touching == 0);
    CHECK(again.error_N >= all.wrench_W.force.norm());
    CHECK(look(kPlenty_us, X_WO).n_touching == all.n_touching);
    CHECK(look(kNone_us, X_WO).n_touching == all.n_touching);
}

TEST_CASE("tool budget: out of time a sweep ends short of the wall; a bad budget is refused") {
    // 20 m/s through a block of 4 cm: each step would pass 20 voxels.
    VoxelToolSettings settings = make_settings(25.0);
    FieldTool tool = make_plate(settings);
    tool.place(lie(-5.0e-3));
    double y_m = lie(-5.0e-3).position.y();
    for (int i = 1; i <= 40; ++i) {
        y_m -= 0.02;
        const ToolFelt felt =
            tool.move({Pose::at({0.0, y_m, 0.0}), {{0.0, -20.0, 0.0}, Vector3::Zero()}},
                      std::vector<MovingFrame>(1), i * kDt_s, kDt_s);
        REQUIRE(felt.moved);
    }
    CHECK(tool.state().pose_W.position.y() > kTop_m);
    CHECK(tool.state().pose_W.position.y() < lie(-3.0e-3).position.y());
    for (const double budget_us : {-1.0, 1.0, 2.0e5}) {
        CHECK_FALSE(validate(make_settings(budget_us)));
    }
    CHECK(validate(make_settings(0.0)));
    CHECK(validate(make_settings(125.0)));
}
