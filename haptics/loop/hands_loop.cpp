#include "haptics/loop/hands_loop.h"

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace fulcrum {

// `step_one(i)` makes the round of hand i.
template <class StepOne>
void HandsLoop::run_round(const StepOne& step_one) noexcept {
    const HandInRound& first = hands_.front();
    const bool was_stopped = first.loop->state().gate == GatePhase::stopped;
    first.channels->others_still.store(
        std::all_of(hands_.begin() + 1, hands_.end(),
                    [](const HandInRound& other) { return other.loop->is_still(); }),
        std::memory_order_release);
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        HapticChannels& channels = *hands_[i].channels;
        if (i > 0) {
            pass_on(channels, was_stopped && first.loop->state().gate != GatePhase::stopped);
        }
        channels.other_stopped.store(is_stopped_beside(i), std::memory_order_release);
        step_one(i);
        stops_[i] = any(hands_[i].loop->state().faults & Fault::emergency_stop) ? 1 : 0;
    }
}

// What stops another hand only because this one does would hold both for ever.
bool HandsLoop::is_stopped_beside(std::size_t hand) const noexcept {
    for (std::size_t i = 0; i < stops_.size(); ++i) {
        if (i != hand && stops_[i] != 0) {
            return true;
        }
    }
    return false;
}

void HandsLoop::step(double now_s) noexcept {
    run_round([&](std::size_t i) { hands_[i].loop->step(now_s); });
}

void HandsLoop::step_observed(double now_s, StageListener& listener) noexcept {
    run_round([&](std::size_t i) {
        listener.begins_hand(i);
        hands_[i].loop->step_observed(now_s, listener);
    });
}

// The first one's loop alone takes its switches; the others hear of it here.
void HandsLoop::pass_on(HapticChannels& other, bool is_lifted) const noexcept {
    const HapticChannels& said = *hands_.front().channels;
    const auto copy = [](const std::atomic<bool>& from, std::atomic<bool>& to) {
        to.store(from.load(std::memory_order_acquire), std::memory_order_release);
    };
    copy(said.lesson_failed, other.lesson_failed);
    copy(said.ended, other.ended);
    if (is_lifted) {
        other.rearm.store(true, std::memory_order_release);
    }
}

void HandsLoop::silence(double now_s) noexcept {
    for (const HandInRound& hand : hands_) {
        hand.loop->silence(now_s);
    }
}

}  // namespace fulcrum
