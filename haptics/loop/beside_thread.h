// A thread for the work that a tool has beside the haptic steps (tool/beside_task.h): calls it again and again, keeps statistics of it.
//
// A place is told once a haptic round; the thread looks for one twice as often, so that a round of work that is short is told before the
// next step, and one that is long is followed by the next at once, or within half a step. It runs under the haptic thread's priority and over
// what has none, where the machine has a processor to spare for it; else as any thread.
// What is felt when it stalls, dies or is stopped is the haptic loop's affair (tool/contact_age.h); here it is told.
//
// Thread: as RealtimeThread; the statistics are told to any. Cost: a wake-up a look.
#pragma once

#include "haptics/loop/latency_histogram.h"
#include "haptics/loop/realtime_thread.h"
#include "haptics/tool/beside_task.h"

#include <atomic>
#include <cstdint>

namespace fulcrum {

/// How the work does.
struct BesideStatus {
    bool running = false;
    bool failed = false;       ///< it threw; the thread has ended
    std::uint64_t rounds = 0;  ///< in which there was something to do
    double rate_Hz = 0.0;   ///< such rounds a second, from the first start to now, or to the stop
    double median_s = 0.0;  ///< what one took
    double p99_s = 0.0;
    double most_s = 0.0;
};

class BesideThread {
  public:
    /// Looks a second, of a haptic loop of that rate.
    [[nodiscard]] static double compute_looks_Hz(double haptic_rate_Hz) noexcept;

    /// Starts calling `task`, which must live until `stop` has returned, `looks_Hz` times a second if it can. Fails as RealtimeThread does.
    [[nodiscard]] Expected<void> start(BesideTask& task, double looks_Hz, double epoch_s);
    /// After its round.
    void stop() noexcept;
    [[nodiscard]] BesideStatus status() const;

  private:
    // The task, counted.
    class Counted final : public PeriodicTask {
      public:
        void step(double now_s) override;
        void silence(double /*now_s*/) noexcept override {}

        BesideTask* task = nullptr;
        std::atomic<std::uint64_t> rounds{0};
        LatencyHistogram duration{};
    };

    Counted counted_;
    RealtimeThread thread_;
    double started_s_ = 0.0;
    double stopped_s_ = 0.0;  // 0: not yet
};

}  // namespace fulcrum
