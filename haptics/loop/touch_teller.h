// Tells the sound what a touch is like, once a round, while an audible solid is touched (handover/touch_sample.h).
//
// Thread: haptic loop. Cost: one push into a ring. No allocation in `step`.
#pragma once

#include "haptics/handover/touch_sample.h"
#include "haptics/loop/contact_stage.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/loop/texture_stage.h"
#include "haptics/loop/touch_motion.h"

#include <span>
#include <vector>

namespace fulcrum {

class TouchTeller {
  public:
    [[nodiscard]] static bool is_needed(const HapticPlan& plan) noexcept;
    /// Takes a plan that `validate` accepted. The ring outlives it.
    TouchTeller(const HapticPlan& plan, TouchRing& ring);

    /// After the motion was stepped, and the texture, which is null where the plan has none.
    void step(std::span<const TouchForce> touches, const TouchMotion& motion,
              const TextureStage* texture, double time_s) noexcept;

  private:
    TouchRing& ring_;
    std::vector<char> audible_;  // one a solid
    bool told_ = false;          // the last sample told of a touch
};

}  // namespace fulcrum
