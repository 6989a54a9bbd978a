#include "runtime/app/stop_keys.h"

namespace fulcrum::runtime {

void StopKeys::watch(HapticChannels* channels) noexcept {
    channels_ = channels;
    if (channels_ != nullptr && stopped_) {
        channels_->emergency_stop.press();
    }
}

StopKey StopKeys::take(std::string_view key, bool repeat, const RunState& run) noexcept {
    if (repeat) {
        return StopKey::nothing;
    }
    if (key == "escape" && (run.failed || run.finished || stopped_)) {
        return StopKey::leave;
    }
    if (key == "escape") {
        press(!run.renders_force);
        return StopKey::press;
    }
    if ((key == "return" || (key == "p" && is_pause_)) && stopped_ && !run.failed) {
        lift();
        return StopKey::lift;
    }
    return StopKey::nothing;
}

void StopKeys::switch_pause() noexcept {
    if (stopped_ && is_pause_) {
        lift();
    } else if (!stopped_) {
        press(true);
    }
}

void StopKeys::lose_focus(bool renders_force, bool plays) noexcept {
    if (channels_ != nullptr && !stopped_ && (renders_force || plays)) {
        press(plays);
        goes_on_ = !plays;
    }
}

void StopKeys::hear(unsigned seen) noexcept {
    if (seen != heard_) {
        heard_ = seen;
        press(false);
    }
}

void StopKeys::watch_gate(bool is_stopped) noexcept {
    // What was lifted just now takes a while to be seen.
    constexpr int kFramesSure = 20;
    stopped_frames_ = is_stopped && !stopped_ ? stopped_frames_ + 1 : 0;
    if (stopped_frames_ >= kFramesSure) {
        stopped_frames_ = 0;
        press(false);
    }
}

void StopKeys::press(bool is_pause) noexcept {
    is_pause_ = is_pause;
    goes_on_ = false;
    stopped_ = true;
    if (channels_ != nullptr) {
        channels_->emergency_stop.press();
    }
}

void StopKeys::lift() noexcept {
    stopped_ = false;
    if (channels_ != nullptr) {
        channels_->emergency_stop.release();
        channels_->rearm.store(true, std::memory_order_release);
    }
}

}  // namespace fulcrum::runtime
