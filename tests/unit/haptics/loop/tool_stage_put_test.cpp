// A solid that is put elsewhere at once, as a lesson's that is hidden and shown.
#include "haptics/loop/tool_stage.h"
#include "tests/support/tool_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <span>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kTop_m = 0.05;  // well over where the tool begins to feel the floor

// A box of 20 x 4 x 20 cm whose top is at height 0, and a ball of 2 cm.
HapticPlan make_floor(ToolMethod method) {
    HapticPlan plan;
    plan.solids.push_back({.body = 0,
                           .shape = BoxShape{Vector3(0.1, 0.02, 0.1)},
                           .initial_pose_W = Pose::at(Vector3(0, -0.02, 0))});
    plan.tool =
        test::make_tool_of(test::make_ball_tool(method), {make_box({0.2, 0.04, 0.2}).value()});
    return plan;
}

ToolRound make_round(const Vector3& hand_W, std::span<const Pose> solids_W, double now_s) {
    return {
        .hand = {Pose::at(hand_W), {}}, .solid_poses_W = solids_W, .now_s = now_s, .dt_s = kDt_s};
}

}  // namespace

TEST_CASE(
    "tool stage: a solid that was put elsewhere at once, from however far, is felt as one that "
    "always stood there, by every method") {
    const auto method = GENERATE(ToolMethod::field_sampling, ToolMethod::voxel_sampling,
                                 ToolMethod::implicit_penalty, ToolMethod::god_object);
    const HapticPlan plan = make_floor(method);
    const Pose here[] = {plan.solids[0].initial_pose_W};
    const Pose gone[] = {Pose::at(Vector3(0, -2.0e4, 0))};
    const auto stage = make_tool_stage(plan);
    const auto still = make_tool_stage(plan);
    double now_s = 0.0;
    const auto step = [&](double y, std::span<const Pose> solids) {
        now_s += kDt_s;
        const Vector3 hand_W(0, y, 0);
        const ToolForce felt = stage->step(make_round(hand_W, solids, now_s));
        return (felt.wrench_W.force - still->step(make_round(hand_W, here, now_s)).wrench_W.force)
            .norm();
    };
    // Shown for a moment while the hand is in it, hidden, and shown again a second later.
    (void)step(0.0, here);
    stage->let_go(1U);
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(step(kTop_m, gone) == 0.0);
    }
    stage->let_go(1U);
    double most_N = 0.0;
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(step(kTop_m - 0.00005 * i, here) < 1.0e-6);
        most_N = std::max(most_N, stage->pushes()[0].force_W.norm());
    }
    CHECK(most_N > 1.0);
}
