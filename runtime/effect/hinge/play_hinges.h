// Bodies on hinges in one play of a lesson: what it wants of them, and how the hand's loop has turned them. Axles are in the order of the
// bodies that have a hinge.
//
// Thread: lesson loop.
#pragma once

#include "haptics/base/error.h"
#include "runtime/lesson/session_messages.h"
#include "runtime/scene/description.h"

namespace fulcrum::runtime {

class PlayedHinges {
  public:
    /// The description outlives it.
    explicit PlayedHinges(const LessonDescription& lesson) : lesson_(lesson) {}

    /// How they stand goes into the frame, behind the bodies' own places.
    void take(const SessionInput& input, LessonFrame& frame);
    /// An error where the body has none.
    [[nodiscard]] Expected<void> carry_out(const TurnCommand& command);
    /// As ordered so far.
    void order(EffectOrders& orders) const { orders.axles = orders_; }

  private:
    const LessonDescription& lesson_;
    AxleOrders orders_{};
};

}  // namespace fulcrum::runtime
