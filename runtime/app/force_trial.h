// A learner's first use of an arm or a joystick with force (lesson/first_use.h) on the device itself, before a lesson's loops have it: a haptic loop of its own that
// lets through kMostPush_N at most, behind the same gate and guard, on a thread of its own; the pushes are commanded from here.
//
// Thread: that of the run, but for its own haptic thread.
#pragma once

#include "dialogue/catalogue.h"
#include "haptics/base/error.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/loop/realtime_thread.h"
#include "runtime/app/desktop.h"
#include "runtime/app/lesson_run.h"
#include "runtime/lesson/first_use.h"

#include <memory>
#include <optional>

namespace fulcrum::runtime {

class ForceTrial {
  public:
    /// Starts the loop on the device, which outlives it; `limits` are the lesson's.
    [[nodiscard]] static Expected<std::unique_ptr<ForceTrial>> begin(Device& device,
                                                                     const SafetySettings& limits,
                                                                     bool asks,
                                                                     const TriedDevice& tried);
    ForceTrial(const ForceTrial&) = delete;
    ForceTrial& operator=(const ForceTrial&) = delete;
    /// Fades what is felt, and ends the loop.
    ~ForceTrial();

    /// Commands what is due; some 60 times a second. While it `rests` nothing is pushed, and no time passes for the trial.
    void frame(bool rests);
    [[nodiscard]] FirstUse& trial() { return trial_; }
    [[nodiscard]] HapticChannels& channels() { return channels_; }

  private:
    ForceTrial(bool asks, const TriedDevice& tried) : trial_(asks, tried) {}

    FirstUse trial_;
    HapticChannels channels_{};
    std::unique_ptr<HapticLoop> loop_;
    RealtimeThread thread_;
    double epoch_s_ = 0.0;
    double framed_s_ = 0.0;  // the last frame
    double rested_s_ = 0.0;  // so far
    double fade_s_ = 0.0;
};

/// Without a window: the arm is watched and nobody is asked, where the learner has not used it; a guest never has. Tells what comes of it.
[[nodiscard]] Expected<void> try_forces(LessonRun& run, const RunRequest& request,
                                        ProgressStore& store);

/// How the learner left a trial in a window.
enum class TrialLeft : std::uint8_t { done, to_menu, closed, time_is_up };

/// In a window: watched, and the learner asked in words and by choices. Ends at `end_s` of the monotonic clock.
[[nodiscard]] Expected<TrialLeft> try_forces_in_window(LessonRun& run, const RunRequest& request,
                                                       ProgressStore& store, Desktop& desktop,
                                                       const dialogue::Catalogue& catalogue,
                                                       std::optional<double> end_s);

}  // namespace fulcrum::runtime
