// The threads of a lesson that is played in real time: hand, world and kite, as far as it has them. The lesson loop is the caller's own.
#pragma once

#include "haptics/loop/realtime_thread.h"
#include "runtime/app/lesson_run.h"

#include <string>

namespace fulcrum::runtime {

class LiveLoops {
  public:
    LiveLoops() = default;
    LiveLoops(const LiveLoops&) = delete;
    LiveLoops& operator=(const LiveLoops&) = delete;
    /// Stops first.
    ~LiveLoops() { stop(); }

    /// Starts the loops that the run's plan has; time zero is `epoch_s` of the monotonic clock. The run outlives them.
    [[nodiscard]] Expected<void> start(LessonRun& run, double epoch_s);
    /// Ends all threads; the device is left without force.
    void stop() noexcept;

    /// How well the haptic loop kept its time, a sentence.
    [[nodiscard]] std::string describe_pace() const;
    [[nodiscard]] RealtimeStatus haptic_status() const { return haptic_.status(); }
    [[nodiscard]] const LatencyHistogram& lateness() const { return haptic_.lateness(); }
    [[nodiscard]] const LatencyHistogram& duration() const { return haptic_.duration(); }

  private:
    RealtimeThread haptic_;
    RealtimeThread world_;
    RealtimeThread kite_;
};

}  // namespace fulcrum::runtime
