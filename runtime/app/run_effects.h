// All that runs in a lesson beside its hands: built from the plan and nothing more, told what the lesson orders, and asked what is new.
//
// Thread: the lesson's; each loop's task belongs to that loop.
#pragma once

#include "runtime/app/running_effect.h"
#include "runtime/lesson/session.h"

#include <memory>
#include <vector>

namespace fulcrum::runtime {

class RunEffects {
  public:
    /// Before the hands' loops. Parts outlive it.
    [[nodiscard]] Expected<void> build(const EffectParts& parts);
    /// Fills in how much memory they use.
    void measure(std::vector<PlanStage>& stages) const;

    /// What is new goes into the session's input.
    void gather(const LessonDescription& lesson, SessionInput& gathered);
    /// What the lesson wants of them. An error where it wants more than can be told.
    [[nodiscard]] Expected<void> order(const EffectOrders& orders);

    /// As of the last `gather`.
    [[nodiscard]] const EffectFrames& frames() const { return frames_; }
    /// Nothing without a world of rigid bodies.
    [[nodiscard]] WorldEffort world_effort() const {
        return frames_.world != nullptr ? frames_.world->effort : WorldEffort{};
    }
    [[nodiscard]] const std::vector<EffectLoop>& loops() const { return loops_; }
    [[nodiscard]] SoundStream* touch_sound() const;
    /// What was not told for want of time or place.
    [[nodiscard]] std::uint64_t n_events_dropped() const;
    [[nodiscard]] std::uint64_t n_commands_ignored() const;

  private:
    std::vector<std::unique_ptr<RunningEffect>> running_;
    std::vector<EffectLoop> loops_;
    EffectFrames frames_{};
};

}  // namespace fulcrum::runtime
