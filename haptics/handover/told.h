// What a haptic loop was told in a round, besides when it was and where the hand is: with it a round can be repeated to the bit whatever
// clocks the others keep.
#pragma once

#include "haptics/base/fault.h"

#include <cstdint>

namespace fulcrum {

/// A value that a round took, newer than the last one's.
template <class T>
struct Told {
    std::uint64_t tick = 0;  ///< the round
    T value{};
};

/// What a device told besides a pose.
struct ToldReading {
    Fault faults = Fault::none;
    bool is_reading = true;  ///< false: what it gave was no pose (device/device.h, is_reading)
};

}  // namespace fulcrum
