#include "haptics/loop/realtime_thread.h"

#include "haptics/base/clock.h"
#include "haptics/base/flush_to_zero.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <pthread.h>
#include <sched.h>
#include <sstream>
#include <sys/mman.h>
#include <sys/resource.h>
#include <system_error>
#include <time.h>
#include <unistd.h>
#include <utility>

namespace fulcrum {
namespace {

timespec to_timespec(double time_s) noexcept {
    const double whole_s = std::floor(time_s);
    return {static_cast<time_t>(whole_s), static_cast<long>((time_s - whole_s) * 1e9)};
}

// Sleeps until spin_s before `deadline_s` of the monotonic clock, then spins.
void wait_until(double deadline_s, double spin_s) noexcept {
    const timespec wake = to_timespec(deadline_s - spin_s);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) == EINTR) {
    }
    while (monotonic_now_s() < deadline_s) {
#if defined(__SSE2__)
        __builtin_ia32_pause();
#endif
    }
}

// 0, or why not. Under a limit nothing is locked: what the program asks for later could no longer be had
// (mlockall(2), MCL_FUTURE).
int lock_memory() noexcept {
    rlimit limit{};
    if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
        geteuid() != 0) {
        return EPERM;
    }
    return mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0 ? 0 : errno;
}

std::string describe_privilege(const char* granted, const char* refused, int error) {
    if (error < 0) {
        return {};
    }
    return error == 0 ? std::string(", ") + granted
                      : std::string(", ") + refused + " (" + std::strerror(error) + ")";
}

}  // namespace

Expected<void> validate(const RealtimeSettings& s) {
    if (!(s.rate_Hz >= 1.0 && s.rate_Hz <= 10000.0)) {
        return fail("the thread's rate is outside the range 1 to 10000 Hz", {},
                    "set it within that range");
    }
    if (!(s.spin_s >= 0.0 && s.spin_s <= kLongestSpin_s)) {
        return fail("the thread's spin is outside the range 0 to 200 microseconds", {},
                    "set it within that range");
    }
    if (s.fifo_priority < 0 || s.fifo_priority > 99) {
        return fail("the thread's priority is outside the range 0 to 99", {},
                    "set it within that range");
    }
    if (s.slept_s == nullptr) {
        return fail("the thread has nothing that tells how long the machine slept", {},
                    "leave it as it is");
    }
    if (!std::isfinite(s.epoch_s)) {
        return fail("the thread's epoch is not finite", {}, "set it to the clock at the start");
    }
    return {};
}

RealtimeThread::~RealtimeThread() {
    stop();
}

Expected<void> RealtimeThread::start(PeriodicTask& task, const RealtimeSettings& settings) {
    if (auto valid = validate(settings); !valid) {
        return valid;
    }
    if (thread_.joinable()) {
        return fail("the thread runs already", {}, "stop it first");
    }
    settings_ = settings;
    settings_.spin_s = std::min(settings.spin_s, 1.0 / (3.0 * settings.rate_Hz));
    stop_wanted_.store(false, std::memory_order_relaxed);
    failed_.store(false, std::memory_order_relaxed);
    running_.store(true, std::memory_order_release);
    try {
        thread_ = std::thread([this, &task] { run(task); });
    } catch (const std::system_error& error) {
        running_.store(false, std::memory_order_release);
        return fail(std::string("the system gives no thread: ") + error.what(), {},
                    "close other programs");
    }
    return {};
}

void RealtimeThread::stop() noexcept {
    stop_wanted_.store(true, std::memory_order_release);
    if (thread_.joinable()) {
        thread_.join();
    }
}

double RealtimeThread::run_time_s() const noexcept {
    return monotonic_now_s() - settings_.epoch_s;
}

void RealtimeThread::ask_for_privileges() noexcept {
    if (settings_.fifo_priority > 0) {
        sched_param parameter{};
        parameter.sched_priority = settings_.fifo_priority;
        fifo_errno_.store(pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter),
                          std::memory_order_release);
    }
    if (settings_.lock_memory) {
        memory_errno_.store(lock_memory(), std::memory_order_release);
    }
}

void RealtimeThread::run(PeriodicTask& task) noexcept {
    ask_for_privileges();
    const ScopedFlushToZero flush_to_zero;
    try {
        run_rounds(task);
    } catch (...) {
        failed_.store(true, std::memory_order_release);
    }
    task.silence(run_time_s());
    running_.store(false, std::memory_order_release);
}

// Both clocks are read once in a round: some 50 ns.
bool RealtimeThread::was_asleep(double since_s) noexcept {
    constexpr double kShortestSleep_s = 10.0 * kSleptWithin_s;
    const double slept_s = settings_.slept_s();
    const bool machine_slept = slept_s - slept_s_ > kShortestSleep_s;
    slept_s_ = machine_slept ? slept_s : std::max(slept_s, slept_s_);
    return machine_slept || since_s > kLongestPause_s + 1.0 / settings_.rate_Hz;
}

void RealtimeThread::run_rounds(PeriodicTask& task) {
    slept_s_ = settings_.slept_s();
    const double period_s = 1.0 / settings_.rate_Hz;
    const double start_s = monotonic_now_s();
    // Counting periods, not adding them up, keeps rounding from drifting.
    std::uint64_t k = 0;
    double before_s = start_s;  // when the last round began
    while (!stop_wanted_.load(std::memory_order_acquire)) {
        const double deadline_s = start_s + static_cast<double>(k) * period_s;
        wait_until(deadline_s, settings_.spin_s);
        const double began_s = monotonic_now_s();
        if (was_asleep(began_s - std::exchange(before_s, began_s))) {
            pauses_.store(pauses_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
            task.silence(began_s - settings_.epoch_s);
        }
        task.step(began_s - settings_.epoch_s);
        const double ended_s = monotonic_now_s();
        lateness_.add(began_s - deadline_s);
        duration_.add(ended_s - began_s);
        rounds_.store(rounds_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        // The next time that is not past already.
        const double passed = std::floor((ended_s - start_s) / period_s);
        const std::uint64_t next = std::max(k + 1, static_cast<std::uint64_t>(passed) + 1);
        misses_.store(misses_.load(std::memory_order_relaxed) + (next - k - 1),
                      std::memory_order_relaxed);
        k = next;
    }
}

RealtimeStatus RealtimeThread::status() const {
    RealtimeStatus status;
    status.running = running_.load(std::memory_order_acquire);
    status.failed = failed_.load(std::memory_order_acquire);
    const int fifo = fifo_errno_.load(std::memory_order_acquire);
    const int memory = memory_errno_.load(std::memory_order_acquire);
    status.has_fifo = fifo == 0;
    status.has_locked_memory = memory == 0;
    status.rounds = rounds_.load(std::memory_order_relaxed);
    status.misses = misses_.load(std::memory_order_relaxed);
    status.pauses = pauses_.load(std::memory_order_relaxed);
    std::ostringstream sentence;
    sentence << settings_.rate_Hz << " Hz"
             << describe_privilege(
                    ("SCHED_FIFO " + std::to_string(settings_.fifo_priority)).c_str(),
                    "without SCHED_FIFO", fifo)
             << describe_privilege("memory locked", "memory not locked", memory);
    if (status.pauses > 0) {
        sentence << ", asleep " << status.pauses << (status.pauses == 1 ? " time" : " times");
    }
    if (status.failed) {
        sentence << ", stopped by an error in its task";
    }
    status.sentence = sentence.str();
    return status;
}

}  // namespace fulcrum
