// A hand that taps a block: what the scene asks for and what is sent, with the plan and the gate that a lesson gets.
#pragma once

#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/workspace.h"
#include "haptics/surface/materials.h"
#include "runtime/scene/compile_plan.h"
#include "tests/support/sent_force.h"
#include "tests/support/tap_judge.h"
#include "tests/support/touchable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fulcrum::test {

struct TapTrial {
    Material material{};
    HumanImpedance hand = kPosture;  ///< it holds a desktop arm
    double speed_m_per_s = 0.1;
    double angle_rad = 0.0;  ///< off the normal
    double begin_m = 0.02;   ///< how far away the hand starts
};

/// The forces of 80 ms. `change` may alter the gate of the plan.
template <class Change>
[[nodiscard]] TapForces tap(const TapTrial& trial, Change&& change) {
    constexpr double kDeep_m = 0.004;  // where the hand wants to end
    constexpr double kTop_m = 0.1;     // of the block
    static const auto kBlock = touchable(make_box({0.2, 0.2, 0.2}));
    HapticPlan plan = runtime::compile_plan(make_touch_lesson(trial.material, false), {},
                                            [](const auto&) { return kBlock; })
                          .value()
                          .haptic;
    plan.expects_lesson = false;
    plan.expects_world = false;
    change(plan.safety);
    const Vector3 way_W(-std::sin(trial.angle_rad), -std::cos(trial.angle_rad), 0.0);
    const Vector3 begin_W = Vector3(0.0, kTop_m, 0.0) - trial.begin_m * way_W;
    SimulatedArmSettings settings = make_desktop_arm();
    settings.dry_friction_N = 0.0;
    settings.max_force_N = 10.0;
    settings.human = trial.hand;
    settings.start_D = compute_device_pose(plan.workspace, Pose::at(begin_W)).position;
    LatestValue<HandTarget> target;
    SimulatedArm arm(settings, target);
    HapticChannels channels;
    HapticLoop loop(plan, arm, channels);
    TapForces forces;
    FeltJudge judge;
    double now_s = 0.0;
    const auto step = [&](double gone_m, double speed_m_per_s) {
        target.publish({compute_device_pose(plan.workspace, Pose::at(begin_W + gone_m * way_W)),
                        speed_m_per_s / plan.workspace.scale *
                            (plan.workspace.pose_WD.orientation.conjugate() * way_W),
                        0});
        now_s += kTapRound_s;
        loop.step(now_s);
        const HapticState& state = loop.state();
        const FeltLimit broken =
            judge.judge(felt_limits(plan.safety),
                        {state.commanded_W, state.applied_W, state.gate, kTapRound_s});
        forces.broken = forces.broken == FeltLimit::none ? broken : forces.broken;
    };
    for (int i = 0; i < 2100; ++i) {
        step(0.0, 0.0);  // until the soft start is over
    }
    const double end_m = trial.begin_m + kDeep_m;
    for (double gone_m = 0.0; forces.sent_N.size() < 80 && now_s < 10.0;) {
        const bool moves = gone_m < end_m;
        gone_m = std::min(gone_m + kTapRound_s * trial.speed_m_per_s, end_m);
        step(gone_m, moves ? trial.speed_m_per_s : 0.0);
        const HapticState& state = loop.state();
        if (state.touched_body >= 0 || !forces.sent_N.empty()) {
            forces.asked_N.push_back(state.commanded_W.force.y());
            forces.sent_N.push_back(state.applied_W.force.y());
            forces.depth_m.push_back(kTop_m - state.tool_pose_W.position.y());
            forces.clips = forces.clips || state.commanded_W.force.norm() > plan.safety.max_force_N;
        }
    }
    return forces;
}

[[nodiscard]] inline TapForces tap(const TapTrial& trial) {
    return tap(trial, [](SafetySettings&) {});
}

/// Materials that are told apart.
inline constexpr std::array kTapped{"metal", "glass", "rock", "wood", "rubber"};

/// A judge that has learnt each of them from eight taps of one hand at one speed, straight on.
[[nodiscard]] inline TapJudge make_taught_judge() {
    TapJudge judge;
    for (const char* name : kTapped) {
        TapTrial trial{*find_material(name)};
        for (int i = 0; i < 8; ++i) {
            // A quarter of a round's way on, so that the touch falls at any time between two rounds.
            trial.begin_m = 0.02 + 0.25 * i * kTapRound_s * trial.speed_m_per_s;
            judge.learn(name, tap(trial));
        }
    }
    return judge;
}

/// Taps of a material by other hands, at other speeds and at other angles.
[[nodiscard]] inline std::vector<TapTrial> unknown_taps(const char* material) {
    constexpr HumanImpedance kLight{0.3, 8.0, 200.0};
    constexpr HumanImpedance kFirm{0.5, 15.0, 600.0};
    std::vector<TapTrial> trials;
    for (const HumanImpedance& hand : {kFingertip, kArm, kLight, kFirm}) {
        for (const double speed_m_per_s : {0.05, 0.075, 0.125, 0.15, 0.2, 0.3, 0.4}) {
            for (const double angle_rad : {0.1, 0.2, 0.3, 0.4, 0.5}) {
                trials.push_back({*find_material(material), hand, speed_m_per_s, angle_rad});
            }
        }
    }
    return trials;
}

}  // namespace fulcrum::test
