// Waits for what another thread does.
#pragma once

#include "haptics/base/clock.h"

#include <chrono>
#include <thread>

namespace fulcrum::test_support {

inline constexpr double kPatience_s = 20.0;  ///< of a machine that is busy with other things

/// Asks every millisecond, until it holds; false where patience ends.
template <class Holds>
bool eventually(const Holds& holds) {
    const double until_s = monotonic_now_s() + kPatience_s;
    while (!holds()) {
        if (monotonic_now_s() > until_s) {
            return false;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

}  // namespace fulcrum::test_support
