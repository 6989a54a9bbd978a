// A thread that calls a task at a fixed rate: sleeps until shortly before the time, spins for the rest,
// keeps statistics.
//
//   t_k = t_0 + k / rate; after a round that ends past t_(k+1) the missed times are skipped and counted
//   lateness = when a round began - t_k;   duration = how long the task took
// SCHED_FIFO and locked memory are asked for; a refusal leaves the thread running and is told by
// `status`. The thread spins for kLongestSpin_s at most: the kernel takes the processor from a
// real-time thread that never sleeps.
//   asleep   a computer that sleeps stops the monotonic clock too, and a program that is stopped (SIGSTOP) only itself: where the one
//            has slept, or a round begins kLongestPause_s later than it should, `silence` comes before the next round, so that nothing of before is
//            felt after, and is counted
// When it stops, or the task throws, `PeriodicTask::silence` is
// called last.
//
// Thread: made, started, stopped, asked for its `status` and destroyed by one thread; the histograms by any.
// Cost: a wake-up a round, and a core for the spin's share of the period.
// Source: clock_nanosleep(2) with absolute times, sched(7), mlockall(2).
#pragma once

#include "haptics/base/clock.h"
#include "haptics/base/error.h"
#include "haptics/base/periodic_task.h"
#include "haptics/loop/latency_histogram.h"

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

namespace fulcrum {

inline constexpr double kLongestSpin_s = 200.0e-6;
inline constexpr double kLongestPause_s = 0.5;

/// Fixed at start.
struct RealtimeSettings {
    double rate_Hz = 1000.0;   ///< 1 to 10000
    double spin_s = 100.0e-6;  ///< 0 to kLongestSpin_s, and at most a third of the period
    int fifo_priority = 80;    ///< 1 to 99 asks for SCHED_FIFO; 0 does not
    bool lock_memory = false;  ///< asks that no page that this program has touched is swapped out
    double (*slept_s)() noexcept = machine_slept_s;  ///< how long the machine has slept in all
    double epoch_s = 0.0;  ///< monotonic_now_s() at the run's zero: tasks see time since then
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const RealtimeSettings& settings);

/// How the thread does, for people.
struct RealtimeStatus {
    bool running = false;
    bool failed = false;    ///< the task threw; the thread has ended
    bool has_fifo = false;  ///< runs under SCHED_FIFO
    bool has_locked_memory = false;
    std::uint64_t rounds = 0;
    std::uint64_t pauses = 0;  ///< how often machine or program had been asleep
    std::uint64_t misses = 0;  ///< times skipped because a round began or ended too late
    std::string
        sentence;  ///< e.g. "1000 Hz, SCHED_FIFO 80, memory locked"; names what was refused and why
};

class RealtimeThread {
  public:
    RealtimeThread() = default;
    RealtimeThread(const RealtimeThread&) = delete;
    RealtimeThread& operator=(const RealtimeThread&) = delete;
    /// Stops first.
    ~RealtimeThread();

    /// Starts calling `task`, which must live until `stop` has returned. Fails with one sentence on bad settings, when it
    /// already runs, or when the system gives no thread. A real-time privilege that is refused is no failure.
    [[nodiscard]] Expected<void> start(PeriodicTask& task, const RealtimeSettings& settings);
    /// Ends the thread after its round and waits for it. Nothing happens when it does not run.
    void stop() noexcept;

    [[nodiscard]] RealtimeStatus status() const;
    /// How late rounds began, over all starts.
    [[nodiscard]] const LatencyHistogram& lateness() const noexcept { return lateness_; }
    /// How long the task's rounds took, over all starts.
    [[nodiscard]] const LatencyHistogram& duration() const noexcept { return duration_; }

  private:
    void run(PeriodicTask& task) noexcept;
    void run_rounds(PeriodicTask& task);
    [[nodiscard]] bool was_asleep(double since_s) noexcept;
    void ask_for_privileges() noexcept;
    [[nodiscard]] double run_time_s() const noexcept;

    RealtimeSettings settings_{};
    std::thread thread_;
    std::atomic<bool> stop_wanted_{false};
    std::atomic<bool> running_{false};
    std::atomic<bool> failed_{false};
    std::atomic<int> fifo_errno_{-1};    // -1 not asked, 0 granted, else why not
    std::atomic<int> memory_errno_{-1};  // likewise
    std::atomic<std::uint64_t> rounds_{0};
    std::atomic<std::uint64_t> misses_{0};
    std::atomic<std::uint64_t> pauses_{0};
    double slept_s_ = 0.0;  // in all, when it was looked at last
    LatencyHistogram lateness_;
    LatencyHistogram duration_;
};

}  // namespace fulcrum
