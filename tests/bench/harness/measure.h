// Times one step, honestly: warmed up, in small batches (the clock itself costs 20 to 30 ns), median and tail of the batches.
#pragma once

#include "tests/bench/harness/report.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
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

/// Calls `step()` warm_up times, then samples x batch times; adds the mean of each batch, microseconds a step, to `us`.
template <class Step>
void time_batches(Step step, const Timing& timing, std::vector<double>& us) {
    using Clock = std::chrono::steady_clock;
    for (int i = 0; i < timing.warm_up; ++i) {
        step();
    }
    us.reserve(us.size() + static_cast<std::size_t>(timing.samples));
    for (int i = 0; i < timing.samples; ++i) {
        const auto before = Clock::now();
        for (int k = 0; k < timing.batch; ++k) {
            step();
        }
        const std::chrono::duration<double, std::micro> took = Clock::now() - before;
        us.push_back(took.count() / timing.batch);
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
