// Times one step, honestly: warmed up, in small batches (the clock itself costs 20 to 30 ns), median and tail of the batches.
#pragma once

#include "tests/bench/harness/report.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <utility>
#include <vector>

namespace fulcrum::bench {

/// How often to time. `batch` steps are timed as one and divided; a p99 is that of batch means, so keep the batch small
/// where tails matter, and 1 for steps above a microsecond.
struct Timing {
    int samples = 2000;
    int batch = 8;
    int warm_up = 200;  ///< steps
};

/// Keeps the optimiser from dropping what computed `value`.
template <class T>
inline void keep(const T& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

/// Processor time of this thread: what others took of the processor is in the clock's, and not in it.
[[nodiscard]] inline double thread_time_us() {
    timespec now{};
    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1.0e6 * static_cast<double>(now.tv_sec) + 1.0e-3 * static_cast<double>(now.tv_nsec);
}

/// What a step took, by the clock and of the processor.
struct Took {
    double clock_us = 0.0;
    double own_us = 0.0;
};

/// Runs `step` once, and asks the clock alone.
template <class Step>
[[nodiscard]] double time_by_clock_us(Step&& step) {
    using Clock = std::chrono::steady_clock;
    const auto before = Clock::now();
    step();
    const std::chrono::duration<double, std::micro> took = Clock::now() - before;
    return took.count();
}

/// Runs `step` once.
template <class Step>
[[nodiscard]] Took time_once(Step step) {
    const double own_before_us = thread_time_us();
    const double took_us = time_by_clock_us(step);
    const double asked_us = thread_time_us();
    // What the question itself takes comes off.
    const double again_us = thread_time_us();
    return {took_us, std::max(0.0, asked_us - own_before_us - (again_us - asked_us))};
}

/// Calls `step()` warm_up times, then samples x batch times; adds the mean of each batch, microseconds a step, to `us`.
template <class Step>
void time_batches(Step step, const Timing& timing, std::vector<double>& us) {
    for (int i = 0; i < timing.warm_up; ++i) {
        step();
    }
    us.reserve(us.size() + static_cast<std::size_t>(timing.samples));
    for (int i = 0; i < timing.samples; ++i) {
        const double batch_us = time_by_clock_us([&] {
            for (int k = 0; k < timing.batch; ++k) {
                step();
            }
        });
        us.push_back(batch_us / timing.batch);
    }
}

/// Median and 99 % of what was timed; at least one.
[[nodiscard]] inline Cost summarise(std::vector<double> us, std::size_t bytes = 0) {
    std::sort(us.begin(), us.end());
    return {us[us.size() / 2], us[us.size() * 99 / 100], bytes};
}

/// Both at once.
template <class Step>
[[nodiscard]] Cost measure_cost(Step step, const Timing& timing = {}, std::size_t bytes = 0) {
    std::vector<double> us;
    time_batches(step, timing, us);
    return summarise(std::move(us), bytes);
}

}  // namespace fulcrum::bench
