// The look before this one: asked again at the same poses it is told again, and where a look is cut short its force stands in for it,
// a step long.
//
// A look of which something was left out is told again within its own step alone: the next one's time may tell more. What was cut short
// tells what the last one did, turned with the object, so that a surface does not go for a moment because the processor did; in the
// step after that it no longer does.
//
// Thread: that of the step. Cost: nanoseconds.
#pragma once

#include "haptics/math/spatial.h"
#include "haptics/tool/field_sampling/field_touch.h"

namespace fulcrum {

class LastLook {
  public:
    void forget() noexcept { is_known_ = false; }
    /// Looks from now on are those of another step.
    void begin_step() noexcept;

    /// Whether it was at these poses and may be told again.
    [[nodiscard]] bool is_known(const Pose& X_WO, const Pose& X_WT) const noexcept;
    [[nodiscard]] const FieldTouch& touch() const noexcept { return touch_; }
    /// It is this one; `in_step`: others of the same step follow.
    void remember(const Pose& X_WO, const Pose& X_WT, const FieldTouch& touch,
                  bool in_step) noexcept;
    /// Where a look left something out, as it was cut short, and the last one had more, that one's force in its place.
    void hold(const Pose& X_WO, bool is_cut_short, FieldTouch& touch) noexcept;

  private:
    Pose X_WO_, X_WT_;
    FieldTouch touch_;
    bool is_known_ = false;
    bool is_known_in_step_ = false;
    bool is_held_ = false, was_held_ = false;  // in this step, in the one before
};

}  // namespace fulcrum
