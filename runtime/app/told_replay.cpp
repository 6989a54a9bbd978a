#include "runtime/app/told_replay.h"

#include "haptics/flight/kite_loop.h"
#include "haptics/loop/stage_listener.h"
#include "runtime/app/repeated_faults.h"

#include <utility>

namespace fulcrum::runtime {
namespace {

template <class T>
void publish_told(const Record& record, const RecordTold& told, LatestValue<T>& to) noexcept {
    T value;
    read_told(record, told, value);
    to.publish(value);
}

}  // namespace

ToldReplay::ToldReplay(std::vector<Hand> hands) {
    for (Hand& hand : hands) {
        hands_.push_back({std::move(hand)});
    }
}

std::size_t ToldReplay::n_rounds() const {
    const auto& samples = hands_.front().hand.record->samples;
    return samples.empty() ? 0 : static_cast<std::size_t>(samples.back().tick) + 1;
}

void ToldReplay::step(double /*now_s*/) noexcept {
    for (At& at : hands_) {
        begin_round(at);
        at.hand.loop->step(at.time_s);
        pass_on(at);
    }
    ++tick_;
}

void ToldReplay::step_observed(double /*now_s*/, StageListener& listener) noexcept {
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        At& at = hands_[i];
        begin_round(at);
        listener.begins_hand(i);
        at.hand.loop->step_observed(at.time_s, listener);
        pass_on(at);
    }
    ++tick_;
}

void ToldReplay::silence(double now_s) noexcept {
    for (const At& at : hands_) {
        at.hand.loop->silence(now_s);
    }
}

void ToldReplay::begin_round(At& at) noexcept {
    const Record& record = *at.hand.record;
    HapticChannels& channels = *at.hand.told;
    for (; at.next_told < record.told.size() && record.told[at.next_told].tick <= tick_;
         ++at.next_told) {
        tell(at, record.told[at.next_told]);
    }
    if (at.next_sample >= record.samples.size() || record.samples[at.next_sample].tick != tick_) {
        at.time_s += 1.0 / record.header.rate_Hz;
        return;
    }
    const RecordSample& sample = record.samples[at.next_sample++];
    at.time_s = sample.time_s;
    repeat_faults(sample.faults, sample.gate, at.was_stopped, channels);
}

void ToldReplay::tell(const At& at, const RecordTold& told) noexcept {
    const Record& record = *at.hand.record;
    HapticChannels& channels = *at.hand.told;
    switch (told.kind) {
        case RecordToldKind::command:
            return publish_told(record, told, channels.command);
        case RecordToldKind::world:
            return publish_told(record, told, channels.world);
        case RecordToldKind::axles:
            return channels.axles != nullptr ? publish_told(record, told, channels.axles->orders)
                                             : void();
        case RecordToldKind::rigid:
            return channels.rigid != nullptr ? publish_told(record, told, channels.rigid->frame)
                                             : void();
        case RecordToldKind::line:
            return channels.kite != nullptr ? publish_told(record, told, channels.kite->line)
                                            : void();
        case RecordToldKind::reading:
            return;  // the replayed device has it
    }
}

// What the loop told goes on to those who would have heard it.
void ToldReplay::pass_on(At& at) noexcept {
    HapticChannels& told = *at.hand.told;
    HapticChannels& heard = *at.hand.heard;
    const HapticState& state = at.hand.loop->state();
    heard.state_for_world.publish(state);
    heard.state_for_lesson.publish(state);
    if (told.axles != nullptr && heard.axles != nullptr && told.axles->frame.take()) {
        heard.axles->frame.publish(told.axles->frame.value());
    }
    if (told.rigid != nullptr && heard.rigid != nullptr && told.rigid->pushes.take()) {
        heard.rigid->pushes.publish(told.rigid->pushes.value());
    }
    if (told.kite != nullptr && heard.kite != nullptr && told.kite->hand_W.take()) {
        heard.kite->hand_W.publish(told.kite->hand_W.value());
    }
}

}  // namespace fulcrum::runtime
