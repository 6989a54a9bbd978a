#include "haptics/loop/hands_loop.h"

#include <atomic>

namespace fulcrum {

void HandsLoop::step(double now_s) noexcept {
    const HandInRound& first = hands_.front();
    const bool was_stopped = first.loop->state().gate == GatePhase::stopped;
    bool is_stopped = false;
    bool is_lifted = false;
    for (const HandInRound& hand : hands_) {
        if (hand.loop != first.loop) {
            pass_on(*hand.channels, is_stopped, is_lifted);
        }
        hand.loop->step(now_s);
        const HapticState& state = hand.loop->state();
        const bool stops = any(state.faults & Fault::emergency_stop);
        if (hand.loop == first.loop) {
            is_lifted = was_stopped && state.gate != GatePhase::stopped;
        } else if (stops && !is_stopped) {
            first.channels->emergency_stop.tap();
        }
        is_stopped = is_stopped || stops;
    }
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
