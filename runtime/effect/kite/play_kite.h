// A kite in one play of a lesson: what lesson and hand want of it, and what the lesson is told.
//
// Thread: lesson loop.
#pragma once

#include "haptics/base/error.h"
#include "runtime/effect/kite/kite_messages.h"
#include "runtime/lesson/session_messages.h"
#include "runtime/scene/description.h"

namespace fulcrum::runtime {

class PlayedKite {
  public:
    /// As it was declared; nothing flies where none was. The description outlives it.
    explicit PlayedKite(const LessonDescription& lesson);

    /// How it flies goes into the frame; the hand turns its reel.
    void take(const SessionInput& input, LessonFrame& frame);
    /// An error where none was declared, or where its design is none.
    [[nodiscard]] Expected<void> carry_out(const KiteCommand& command);
    [[nodiscard]] Expected<void> carry_out(const WindCommand& command);
    /// As ordered so far; another design is given once.
    void order(EffectOrders& orders);
    [[nodiscard]] const KiteSeen& seen() const { return seen_; }

  private:
    const LessonDescription& lesson_;
    KiteOrders orders_{};
    KiteSeen seen_{};
    bool is_built_anew_ = false;
};

}  // namespace fulcrum::runtime
