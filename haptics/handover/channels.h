// The hand-over between the haptic loop and everything else. Each channel has one writer and one
// reader, named here.
#pragma once

#include "haptics/handover/event_ring.h"
#include "haptics/handover/latest_value.h"
#include "haptics/handover/messages.h"
#include "haptics/handover/record_sample.h"

#include <atomic>

namespace fulcrum {

using RecordRing = EventRing<RecordSample, kRecordRingCapacity>;

/// What one haptic loop reads and writes besides its device. Made before the loop, outlives it.
struct HapticChannels {
    LatestValue<ForceCommand> command;          ///< writer: lesson loop; reader: haptic loop
    LatestValue<WorldFrame> world;              ///< writer: world loop; reader: haptic loop
    LatestValue<HapticState> state_for_world;   ///< writer: haptic loop; reader: world loop
    LatestValue<HapticState> state_for_lesson;  ///< writer: haptic loop; reader: lesson loop
    RecordRing* record =
        nullptr;  ///< writer: haptic loop; reader: recorder; null when nothing is recorded

    /// Set by anybody: the force fades at once and stays zero until `rearm`. Cleared by whoever set
    /// it.
    std::atomic<bool> emergency_stop{false};
    /// Set by anybody while the lesson has failed: the force fades, and comes back softly after it
    /// is cleared.
    std::atomic<bool> lesson_failed{false};
    /// Set by a person's explicit wish; the haptic loop takes it back when it has left the stop. It
    /// waits while `emergency_stop` is still set.
    std::atomic<bool> rearm{false};
};

using WorldCommandRing = EventRing<WorldCommand, 256>;
using WorldEventRing = EventRing<WorldEvent, 256>;

/// What one world loop reads and writes besides the haptic channels.
struct WorldChannels {
    WorldCommandRing commands;  ///< writer: lesson loop; reader: world loop
    WorldEventRing events;      ///< writer: world loop; reader: lesson loop
    LatestValue<WorldSnapshot>
        snapshot;  ///< writer: world loop; reader: lesson loop and picture, one thread
};

}  // namespace fulcrum
