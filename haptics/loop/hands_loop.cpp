#include "haptics/loop/hands_loop.h"

#include <atomic>
#include <cstddef>

namespace fulcrum {

// `step_one(i)` makes the round of hand i.
template <class StepOne>
void HandsLoop::run_round(const StepOne& step_one) noexcept {
    const HandInRound& first = hands_.front();
    const bool was_stopped = first.loop->state().gate == GatePhase::stopped;
    bool is_stopped = false;
    bool is_lifted = false;
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        const HandInRound& hand = hands_[i];
        if (i > 0) {
            pass_on(*hand.channels, is_stopped, is_lifted);
        }
        step_one(i);
        const HapticState& state = hand.loop->state();
        const bool stops = any(state.faults & Fault::emergency_stop);
        if (i == 0) {
            is_lifted = was_stopped && state.gate != GatePhase::stopped;
        } else if (stops && !is_stopped) {
            first.channels->emergency_stop.tap();
        }
        is_stopped = is_stopped || stops;
    }
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
void HandsLoop::pass_on(HapticChannels& other, bool is_stopped, bool is_lifted) const noexcept {
    const HapticChannels& said = *hands_.front().channels;
    const auto copy = [](const std::atomic<bool>& from, std::atomic<bool>& to) {
        to.store(from.load(std::memory_order_acquire), std::memory_order_release);
    };
    copy(said.lesson_failed, other.lesson_failed);
    copy(said.ended, other.ended);
    if (is_stopped) {
        other.emergency_stop.tap();
    } else if (is_lifted) {
        other.rearm.store(true, std::memory_order_release);
    }
}

void HandsLoop::silence(double now_s) noexcept {
    for (const HandInRound& hand : hands_) {
        hand.loop->silence(now_s);
    }
}

}  // namespace fulcrum
