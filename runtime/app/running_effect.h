// One thing that runs in a lesson beside its hands, and the list of them; each stands in its room, runtime/effect/<name>/run_<name>.cpp.
//
// Thread: the lesson's; a loop's task belongs to that loop.
#pragma once

#include "haptics/base/error.h"
#include "haptics/base/periodic_task.h"
#include "haptics/handover/channels.h"
#include "runtime/audio/sound_player.h"
#include "runtime/lesson/effect_messages.h"
#include "runtime/scene/description.h"
#include "runtime/scene/plan.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// What an effect is made from; plan and channels outlive it.
struct EffectParts {
    const Plan& plan;
    std::span<HapticChannels* const> hands;  ///< with the channels of all effects, before the loops
    std::span<const WorldCommand> first;     ///< what a world is told before the first frame
};

/// What is to be called in time; null where nothing is.
struct EffectLoop {
    std::string_view name;  ///< as the plan's stages have it
    double rate_hz = 0.0;
    PeriodicTask* task = nullptr;
};

class RunningEffect {
  public:
    RunningEffect() = default;
    RunningEffect(const RunningEffect&) = delete;
    RunningEffect& operator=(const RunningEffect&) = delete;
    virtual ~RunningEffect() = default;

    /// Takes what is new; what happened since goes to `events`.
    virtual void take(const LessonDescription& /*lesson*/, std::vector<WorldEvent>& /*events*/) {}
    /// The newest that was taken.
    virtual void tell(EffectFrames& /*frames*/) const {}
    /// What the lesson wants. An error where it wants more than can be told.
    [[nodiscard]] virtual Expected<void> order(const EffectOrders& /*orders*/) { return {}; }
    [[nodiscard]] virtual EffectLoop loop() { return {}; }
    /// How much memory it uses for each of the plan's stages that are its own.
    virtual void measure(std::vector<PlanStage>& /*stages*/) const {}
    /// What is heard of it; null where nothing is.
    [[nodiscard]] virtual SoundStream* sound() { return nullptr; }
    /// What was not told for want of time or place.
    [[nodiscard]] virtual std::uint64_t n_events_dropped() const { return 0; }
    [[nodiscard]] virtual std::uint64_t n_commands_ignored() const { return 0; }
};

/// Makes one where the plan has it, else nothing.
using EffectMaker = Expected<std::unique_ptr<RunningEffect>>(const EffectParts& parts);
EffectMaker run_touch_sound, run_hinges, run_falling, run_rigid, run_kite;
/// All of them, in the order in which their loops have their rounds.
inline constexpr EffectMaker* kEffects[] = {run_touch_sound, run_hinges, run_falling, run_rigid,
                                            run_kite};

}  // namespace fulcrum::runtime
