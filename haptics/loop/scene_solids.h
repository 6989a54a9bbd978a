// The solids of a hand's scene: where each is in this round, turned on its axle or moved by the world of rigid bodies, and how the hand
// presses them.
//
// Thread: haptic loop. Cost: that of its stages; no allocation in `step`.
#pragma once

#include "haptics/handover/channels.h"
#include "haptics/loop/axle_stage.h"
#include "haptics/loop/body_stage.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/loop/solid_places.h"

#include <cstdint>
#include <memory>
#include <span>

namespace fulcrum {

class SceneSolids {
  public:
    /// Takes a plan that `validate` accepted.
    SceneSolids(const HapticPlan& plan, const HapticChannels& channels)
        : axles(make_axle_stage(plan, channels.axles)),
          bodies(make_body_stage(plan, channels.rigid)),
          places_(plan),
          may_move_(plan.expects_world || axles || bodies) {}

    /// First in a round: takes the world's newest frame over, null where none has come. False where a pose in it is no number: then there
    /// are no poses in this round.
    [[nodiscard]] bool step(const WorldFrame* told, double now_s) noexcept;
    /// There are none in this round.
    void leave() noexcept { poses_W_ = {}; }
    /// One a solid of the plan; valid as long as the frame.
    [[nodiscard]] std::span<const Pose> poses_W() const noexcept { return poses_W_; }
    /// Bit i: solid i was put elsewhere at once in the last step.
    [[nodiscard]] std::uint32_t put() const noexcept { return put_; }
    /// The scene's index of a solid; kNoBody where the plan has none of that index.
    [[nodiscard]] std::int32_t body_of(std::int32_t solid) const noexcept {
        return places_.body_of(solid);
    }
    /// Whether any may be elsewhere in the next round.
    [[nodiscard]] bool may_move() const noexcept { return may_move_; }

    // Those that the plan has; each is pressed in turn.
    std::unique_ptr<AxleStage> axles;
    std::unique_ptr<BodyStage> bodies;

  private:
    SolidPlaces places_;
    bool may_move_;
    std::span<const Pose> poses_W_{};
    std::uint32_t put_ = 0;
};

}  // namespace fulcrum
