// What somebody outside a hand's loop did to its gate in a round that is repeated, as that round's faults and phase tell it: a stop, another
// hand's, its lifting, the lesson's failure, the end.
//
// Thread: that of the hand's loop.
#pragma once

#include "haptics/base/fault.h"
#include "haptics/handover/channels.h"

namespace fulcrum::runtime {

/// Before the round; `was_stopped` is kept from round to round.
inline void repeat_faults(Fault faults, GatePhase gate, bool& was_stopped,
                          HapticChannels& channels) noexcept {
    const auto set = [&](std::atomic<bool>& flag, Fault fault) {
        flag.store(any(faults & fault), std::memory_order_release);
    };
    if (any(faults & Fault::emergency_stop)) {
        channels.emergency_stop.tap();
    }
    set(channels.other_stopped, Fault::other_stopped);
    set(channels.lesson_failed, Fault::lesson_failed);
    set(channels.ended, Fault::ended);
    const bool is_stopped = gate == GatePhase::stopped;
    if (was_stopped && !is_stopped) {
        channels.rearm.store(true, std::memory_order_release);
    }
    was_stopped = is_stopped;
}

}  // namespace fulcrum::runtime
