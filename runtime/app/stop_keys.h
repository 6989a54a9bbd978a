// The emergency stop's keys, and the pause's. Escape stops an arm that pushes, pauses where none does, and leaves when it is stopped already
// or nothing is left to stop; return lets it go on. A pause is a stop with other words, and goes on by P as well. Either outlives the run in
// which it was pressed.
//
// Thread: that of the window; the haptic loop hears of it through its channels.
#pragma once

#include "haptics/handover/channels.h"

#include <cstdint>
#include <string_view>

namespace fulcrum::runtime {

/// What a key did.
enum class StopKey : std::uint8_t { nothing, press, lift, leave };

/// What decides it besides the stop.
struct RunState {
    bool failed = false;  ///< there is no lesson that plays
    bool finished = false;
    bool renders_force = true;  ///< a hand's device could push
};

class StopKeys {
  public:
    /// `seen`: how many stops from outside came before this (stop_signals_seen); they were others' business.
    explicit StopKeys(unsigned seen = 0) noexcept : heard_(seen) {}
    /// From now on this run's; null for none. The channels outlive the next call. One that is stopped stays stopped.
    void watch(HapticChannels* channels) noexcept;
    /// A key that went down: "escape", "return" or any other.
    StopKey take(std::string_view key, bool repeat, const RunState& run) noexcept;
    /// P, or the button on the screen: pauses, or goes on from a pause. A stop is lifted by its key alone.
    void switch_pause() noexcept;
    /// Nobody can press a key here any more: what somebody `plays` is paused. Where nobody has begun, an arm that renders forces is stopped,
    /// and the lesson goes on.
    void lose_focus(bool renders_force, bool plays) noexcept;
    /// Somebody has stopped it from outside (stop_signal.h), `seen` times since the program began.
    void hear(unsigned seen) noexcept;
    /// Whether the last gate is stopped, once a frame. One that stays so without a key was stopped at the device: it is a stop like others.
    void watch_gate(bool is_stopped) noexcept;
    /// Of both.
    [[nodiscard]] bool stopped() const noexcept { return stopped_; }
    [[nodiscard]] bool paused() const noexcept { return stopped_ && is_pause_; }
    /// The lesson waits too.
    [[nodiscard]] bool stands_still() const noexcept { return stopped_ && !goes_on_; }

  private:
    void press(bool is_pause) noexcept;
    void lift() noexcept;

    HapticChannels* channels_ = nullptr;
    bool stopped_ = false;
    bool is_pause_ = false;
    bool goes_on_ = false;
    unsigned heard_;          // stops from outside
    int stopped_frames_ = 0;  // of the gate, while no key has stopped it
};

}  // namespace fulcrum::runtime
