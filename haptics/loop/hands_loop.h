// The hands of one run: a haptic loop each, one after the other in one round.
//
//   step(t):  loop 1, loop 2 …, each with its own device, proxy or tool, coupling, guard and gate
//             a stop of one is a stop of all, as long as it is held: those after it in the same round, those before it in the next;
//             they tell Fault::other_stopped, and emergency_stop only of their own; that nothing is left of any force the first one's
//             switch tells, of all
//             what is said to the first one's channels, that the lesson failed, that the run is over, that a stop is lifted, is said to all
// Any other fault is a hand's own: its force fades, the others go on as if it had let go. What they hold may fall; each of them is kept
// within its own limits whatever the others do, so there is nothing that their going on could add.
// One thread and one clock for all: a round takes as long as its loops together, and the same readings give the same bytes.
//
// Thread: `step` and `silence` on the one haptic thread (or a virtual clock). Cost: that of the loops. No allocation after construction.
#pragma once

#include "haptics/base/periodic_task.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/haptic_loop.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fulcrum {

/// A hand's loop, and what was given to it; both outlive who is told of them.
struct HandInRound {
    HapticLoop* loop = nullptr;
    HapticChannels* channels = nullptr;
};

class HandsLoop final : public PeriodicTask {
  public:
    /// The first of `hands`, which are one or more, is the one that people outside speak to.
    explicit HandsLoop(std::span<const HandInRound> hands)
        : hands_(hands.begin(), hands.end()), stops_(hands.size(), 0) {}

    /// One round of each.
    void step(double now_s) noexcept override;
    /// The same rounds, to the byte, telling `listener` whose begins and as each stage ends.
    void step_observed(double now_s, StageListener& listener) noexcept;
    /// Zero force to all devices.
    void silence(double now_s) noexcept override;

  private:
    template <class StepOne>
    void run_round(const StepOne& step_one) noexcept;
    void pass_on(HapticChannels& other, bool is_lifted) const noexcept;
    [[nodiscard]] bool is_stopped_beside(std::size_t hand) const noexcept;

    std::vector<HandInRound> hands_;
    std::vector<char> stops_;  // whether each told a stop of its own last
};

}  // namespace fulcrum
