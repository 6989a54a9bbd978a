// The emergency stop's keys. Escape stops the arm, and leaves when it is stopped already or nothing is left to stop; return
// lets it go on. A stop outlives the run in which it was pressed.
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
};

class StopKeys {
  public:
    /// From now on this run's; null for none. The channels outlive the next call. One that is stopped stays stopped.
    void watch(HapticChannels* channels) noexcept;
    /// A key that went down: "escape", "return" or any other.
    StopKey take(std::string_view key, bool repeat, const RunState& run) noexcept;
    /// Nobody can press a key here any more: an arm that renders forces is stopped.
    void lose_focus(bool renders_force) noexcept;
    [[nodiscard]] bool stopped() const noexcept { return stopped_; }

  private:
    void press() noexcept;
    void lift() noexcept;

    HapticChannels* channels_ = nullptr;
    bool stopped_ = false;
};

}  // namespace fulcrum::runtime
