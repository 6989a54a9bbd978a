// Time in seconds since a loop began, from the machine's monotonic clock or from a virtual one.
#pragma once

#include <chrono>

namespace fulcrum {

/// Seconds of the machine's monotonic clock; only differences mean something.
[[nodiscard]] inline double monotonic_now_s() noexcept {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace fulcrum
