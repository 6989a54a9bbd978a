// A floor that a tool is pressed on, for the tests of the tool stage.
#pragma once

#include "haptics/loop/tool_stage.h"
#include "tests/support/tool_scene.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <memory>
#include <span>
#include <utility>

namespace fulcrum {

inline constexpr double kToolStiffness_N_per_m = 400.0;
inline constexpr double kTop_m = 0.05;  // well over where the tool begins to feel the floor

// A box of 20 x 4 x 20 cm whose top is at height 0, and the tool of a scene, as stiff in the hand at any scale.
inline HapticPlan make_tool_floor(test::ToolScene scene, double scale = 1.0,
                                  double stiffness_N_per_m = kToolStiffness_N_per_m) {
    HapticPlan plan;
    plan.safety.soft_start_s = 0.0;
    plan.safety.max_torque_Nm = 1.0;
    plan.workspace.scale = scale;
    plan.solids.push_back({.body = 3,
                           .shape = BoxShape{Vector3(0.1, 0.02, 0.1)},
                           .initial_pose_W = Pose::at(Vector3(0, -0.02, 0))});
    scene.settings.coupling.shift.stiffness_N_per_m = stiffness_N_per_m / scale;
    plan.tool = test::make_tool_of(scene, {make_box({0.2, 0.04, 0.2}).value()});
    return plan;
}

// A stage that is led by itself, its solids where the plan has them.
struct LedStage {
    explicit LedStage(const HapticPlan& plan) : stage(make_tool_stage(plan)) {
        REQUIRE(stage);
        for (const SolidPlan& solid : plan.solids) {
            solids_W.push_back(solid.initial_pose_W);
        }
    }
    ToolForce step(const Pose& hand_W) {
        now_s += kDt_s;
        return stage->step(
            {.hand = {hand_W, {}}, .solid_poses_W = solids_W, .now_s = now_s, .dt_s = kDt_s});
    }
    ToolForce step(const Vector3& hand_W) { return step(Pose::at(hand_W)); }

    std::unique_ptr<ToolStage> stage;
    std::vector<Pose> solids_W;
    double now_s = 0.0;
};

// In the whole loop: held over the floor until the gate is open.
struct ToolBench : Bench {
    explicit ToolBench(const HapticPlan& plan, bool begins = true) : Bench(plan) {
        if (begins) {
            device.pose_D = Pose::at(Vector3(0, kTop_m / plan.workspace.scale, 0));
            world.solid_poses_W[0] = plan.solids[0].initial_pose_W;
            run(200);
            REQUIRE(state().gate == GatePhase::open);
        }
    }
    // Slowly to a place in the hand's metres, and a second of rest there.
    void go(const Vector3& to_D) {
        const Vector3 from_D = device.pose_D.position;
        for (int i = 1; i <= 300; ++i) {
            device.pose_D.position = from_D + i / 300.0 * (to_D - from_D);
            run(1);
        }
        run(1000);
    }
};

}  // namespace fulcrum
