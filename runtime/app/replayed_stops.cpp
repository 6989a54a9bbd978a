#include "runtime/app/replayed_stops.h"

#include <utility>

namespace fulcrum::runtime {

ReplayedStops::ReplayedStops(std::vector<Hand> told, PeriodicTask& hands) : hands_(hands) {
    for (Hand& hand : told) {
        told_.push_back({std::move(hand)});
    }
}

void ReplayedStops::step(double now_s) {
    repeat(now_s);
    hands_.step(now_s);
}

void ReplayedStops::repeat(double now_s) noexcept {
    // As the replayed device has it: the first sample is now.
    if (!started_ && !told_.empty() && !told_.front().hand.record->samples.empty()) {
        offset_s_ = now_s - told_.front().hand.record->samples.front().time_s;
        started_ = true;
    }
    for (At& at : told_) {
        repeat(at, now_s - offset_s_);
    }
}

void ReplayedStops::repeat(At& at, double time_s) noexcept {
    HapticChannels& channels = *at.hand.channels;
    const std::vector<RecordSample>& samples = at.hand.record->samples;
    for (; at.next < samples.size() && samples[at.next].time_s <= time_s; ++at.next) {
        const RecordSample& sample = samples[at.next];
        const bool is_stopped = sample.gate == GatePhase::stopped;
        if (any(sample.faults & Fault::emergency_stop)) {
            channels.emergency_stop.tap();
        }
        if (at.was_stopped && !is_stopped) {
            channels.rearm.store(true, std::memory_order_release);
        }
        if (any(sample.faults & Fault::ended)) {
            channels.ended.store(true, std::memory_order_release);
        }
        at.was_stopped = is_stopped;
    }
}

}  // namespace fulcrum::runtime
