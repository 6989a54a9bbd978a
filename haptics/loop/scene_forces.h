// What the scene does to the hand in one round: what holds the proxy or the tool off the hand, and the sum of all forces.
//
//   move      the solids are where the world has them now; the proxy, or the tool, follows the hand among them
//   compute   tool, coupling, what turns and is pushed by them, surfaces, weight, fields, line, the lesson's own force: each adds to the
//             sum, and tells what of it gives the hand's work back (coupling/elastic_force.h)
// Only what the plan has is built; what is not in it takes no memory and no time.
//
// Thread: the haptic loop's; built before it starts. Cost: that of its stages; no allocation in a round.
#pragma once

#include "haptics/field/field.h"
#include "haptics/field/linearised_wrench.h"
#include "haptics/field/weight.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/loop/line_stage.h"
#include "haptics/loop/passivity_stage.h"
#include "haptics/loop/round_teller.h"
#include "haptics/loop/safety.h"
#include "haptics/loop/scene_solids.h"
#include "haptics/loop/tool_stage.h"
#include "haptics/loop/touch_stage.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace fulcrum {

/// What the loop knows in one round.
struct SceneRound {
    HapticState&
        state;  ///< where the hand is and what is wrong; takes what is touched, and what more is wrong
    RoundTeller& teller;     ///< is told each effect's share
    const SafetyGate& gate;  ///< as the round before left it
    TouchVelocity::Hand hand;
    double now_s = 0.0;
    double dt_s = 0.0;
    bool has_pose = false;
    bool heard_world = false;
};

class SceneForces {
  public:
    /// Takes a plan that `validate` accepted; plan and channels outlive it. `safety` as the loop's gate has it.
    SceneForces(const HapticPlan& plan, const DeviceTraits& traits, const SafetySettings& safety,
                HapticChannels& channels, std::unique_ptr<Proxy> proxy);

    /// Both in a round, in this order; `passed(stage)` is called as each stage ends (stage_listener.h).
    template <class Passed>
    void move(const SceneRound& round, Passed passed) noexcept;
    template <class Passed>
    void compute(const SceneRound& round, Passed passed) noexcept;
    /// Of the last round: of a hand whose pose is not known it is no demand.
    [[nodiscard]] const SceneDemand& demand() const noexcept { return demand_; }
    /// The hand has jumped to here.
    void forget(const Vector3& hand_W) noexcept;

    /// Whether a proxy touches the solids; a tool where there is one.
    [[nodiscard]] bool has_proxy() const noexcept { return touch_ != nullptr; }
    [[nodiscard]] ToolStage* tool() const noexcept { return tool_.get(); }
    /// What it adds, in the order in which it does.
    [[nodiscard]] std::vector<EffectSlot> list_effects() const;
    /// Adds the stages that there are, in their order.
    void list_stages(std::vector<StageInfo>& list) const;

  private:
    [[nodiscard]] bool find_solids(const SceneRound& round) noexcept;
    void move_proxy(const SceneRound& round) noexcept;
    void move_tool(const SceneRound& round) noexcept;
    void add_tool(RoundTeller& teller) noexcept;
    void add_contact(const SceneRound& round) noexcept;
    void turn_axles(const SceneRound& round) noexcept;
    void push_bodies(const SceneRound& round) noexcept;
    template <class Passed>
    void add_surface(const SceneRound& round, Passed passed) noexcept;
    void add_surface_force(const SurfaceForce& felt) noexcept;
    void add_weight(const SceneRound& round) noexcept;
    void add_field(std::size_t index, const SceneRound& round) noexcept;
    void add_line(const SceneRound& round) noexcept;
    void add_lesson_force(const SceneRound& round) noexcept;

    const HapticPlan& plan_;
    const HapticChannels& channels_;

    // Stages; those not in the plan are empty.
    std::unique_ptr<TouchStage> touch_;
    std::unique_ptr<ToolStage> tool_;
    std::unique_ptr<SceneSolids> solids_;  // where something touches them
    std::unique_ptr<WeightRamp> weight_;
    std::vector<FieldStage> fields_;
    std::unique_ptr<LineStage> line_;
    std::unique_ptr<LinearisedWrenchStage> lesson_force_;

    ToolForce tool_force_{};
    SceneDemand demand_{};
};

}  // namespace fulcrum
