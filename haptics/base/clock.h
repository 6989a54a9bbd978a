// Time in seconds since a loop began, from the machine's monotonic clock or from a virtual one.
#pragma once

#include <chrono>
#include <ctime>

namespace fulcrum {

/// Seconds of the machine's monotonic clock; only differences mean something.
[[nodiscard]] inline double monotonic_now_s() noexcept {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Seconds that the machine has slept since it was started, for which the monotonic clock stands still. Never more than it was, and less
/// by kSleptWithin_s at most: a thread may be interrupted between the two clocks that are compared.
inline constexpr double kSleptWithin_s = 1.0e-3;
[[nodiscard]] inline double machine_slept_s() noexcept {
    const auto read_s = [](clockid_t clock) {
        timespec time{};
        (void)clock_gettime(clock, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    constexpr int kTries = 10;
    double least_s = 0.0;
    for (int i = 0; i < kTries; ++i) {
        const double before_s = read_s(CLOCK_MONOTONIC);
        const double since_start_s = read_s(CLOCK_BOOTTIME);
        const double after_s = read_s(CLOCK_MONOTONIC);
        least_s = since_start_s - after_s;
        if (after_s - before_s <= kSleptWithin_s) {
            break;
        }
    }
    return least_s;
}

}  // namespace fulcrum
