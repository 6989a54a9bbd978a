// Somebody who wants to know when each stage of a haptic round has ended: for measuring and explaining, never in a live run.
#pragma once

#include "haptics/loop/haptic_plan.h"

namespace fulcrum {

class StageListener {
  public:
    StageListener() = default;
    StageListener(const StageListener&) = delete;
    StageListener& operator=(const StageListener&) = delete;
    virtual ~StageListener() = default;

    /// The stage has just been done; the next one begins when this returns.
    virtual void passed(HapticStage stage) noexcept = 0;
    /// Where there are several hands: what passes now is this one's, counted from 0.
    virtual void begins_hand(std::size_t /*hand*/) noexcept {}
};

/// Called as each stage ends where nobody listens: no instruction of it is left.
struct NobodyListens {
    void operator()(HapticStage /*stage*/) const noexcept {}
};

/// And where somebody does.
struct TellsListener {
    StageListener& listener;
    void operator()(HapticStage stage) const noexcept { listener.passed(stage); }
};

}  // namespace fulcrum
