// The threads of a lesson that is played in real time: hands, what finds contact beside them, and the effects that have a loop. The lesson loop is
// the caller's own.
#pragma once

#include "haptics/loop/beside_thread.h"
#include "haptics/loop/realtime_thread.h"
#include "runtime/app/lesson_run.h"

#include <list>
#include <optional>
#include <string>

namespace fulcrum::runtime {

/// How a thread that finds contact did.
struct ContactPace {
    BesideStatus thread{};
    double median_age_s = 0.0;  ///< of what it told, in the haptic loop's rounds
    double p99_age_s = 0.0;
    double most_age_s = 0.0;
};

class LiveLoops {
  public:
    LiveLoops() = default;
    LiveLoops(const LiveLoops&) = delete;
    LiveLoops& operator=(const LiveLoops&) = delete;
    /// Stops first.
    ~LiveLoops() { stop(); }

    /// Starts the loops that the run's plan has; time zero is `epoch_s` of the monotonic clock. The run outlives them.
    [[nodiscard]] Expected<void> start(LessonRun& run, double epoch_s);
    /// The effects' loops stand still, while the hands' go on; `go_on` starts them again from where they were.
    void stand_still() noexcept;
    [[nodiscard]] Expected<void> go_on(LessonRun& run);
    /// Ends all threads; the device is left without force.
    void stop() noexcept;

    /// How well the haptic loop kept its time, a sentence; and another on the contact thread where there is one.
    [[nodiscard]] std::string describe_pace() const;
    /// Of the contact thread, until now or the stop; nothing without one.
    [[nodiscard]] std::optional<ContactPace> contact_pace() const;
    [[nodiscard]] RealtimeStatus haptic_status() const { return haptic_.status(); }
    [[nodiscard]] const LatencyHistogram& lateness() const { return haptic_.lateness(); }
    [[nodiscard]] const LatencyHistogram& duration() const { return haptic_.duration(); }

  private:
    [[nodiscard]] std::string describe_contact() const;

    RealtimeThread haptic_;
    BesideThread contact_;
    const HapticLoop* contact_of_ = nullptr;  // whose contacts it finds; null where it does not run
    std::optional<ContactPace> contact_was_;  // how it did until it was stopped
    std::list<RealtimeThread> effects_;
    double epoch_s_ = 0.0;
};

}  // namespace fulcrum::runtime
