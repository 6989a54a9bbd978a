// The hand-over between the haptic loop and everything else. Each channel has one writer and one
// reader, named here.
#pragma once

#include "haptics/handover/axle_messages.h"
#include "haptics/handover/event_ring.h"
#include "haptics/handover/latest_value.h"
#include "haptics/handover/messages.h"
#include "haptics/handover/record_sample.h"
#include "haptics/handover/rigid_messages.h"
#include "haptics/handover/touch_sample.h"

#include <atomic>

namespace fulcrum {

struct KiteChannels;  // haptics/flight/kite_loop.h
class ToldRings;      // haptics/loop/told_rings.h

using RecordRing = EventRing<RecordRound, kRecordRingCapacity>;

/// A switch whose every press is seen, however short: one that is pressed and released between two
/// looks of the reader is still taken once.
class StopSwitch {
  public:
    /// Any thread; wait-free.
    void press() noexcept {
        pressed_.store(true, std::memory_order_release);
        unseen_.store(true, std::memory_order_release);
    }
    /// A press that is let go at once, whoever else holds it. Any thread; wait-free.
    void tap() noexcept { unseen_.store(true, std::memory_order_release); }
    /// Any thread; wait-free.
    void release() noexcept { pressed_.store(false, std::memory_order_release); }
    /// Whether it is held down now.
    [[nodiscard]] bool is_pressed() const noexcept {
        return pressed_.load(std::memory_order_acquire);
    }
    /// The one reader: true while it is held down, and once after a press that it has not seen.
    [[nodiscard]] bool take() noexcept {
        const bool unseen = unseen_.load(std::memory_order_acquire) &&
                            unseen_.exchange(false, std::memory_order_acq_rel);
        return unseen || is_pressed();
    }
    /// The reader, each round: whether it is stopped and nothing is left of its force. Wait-free.
    void tell_still(bool is_still) noexcept { still_.store(is_still, std::memory_order_release); }
    /// As of the reader's last round. Any thread; wait-free.
    [[nodiscard]] bool is_still() const noexcept { return still_.load(std::memory_order_acquire); }

  private:
    std::atomic<bool> pressed_{false};
    std::atomic<bool> unseen_{false};
    std::atomic<bool> still_{false};
};

/// What one haptic loop reads and writes besides its device. Made before the loop, outlives it.
struct HapticChannels {
    LatestValue<ForceCommand> command;          ///< writer: lesson loop; reader: haptic loop
    LatestValue<WorldFrame> world;              ///< writer: world loop; reader: haptic loop
    LatestValue<HapticState> state_for_world;   ///< writer: haptic loop; reader: world loop
    LatestValue<HapticState> state_for_lesson;  ///< writer: haptic loop; reader: lesson loop
    RecordRing* record =
        nullptr;  ///< writer: haptic loop; reader: recorder; null when nothing is recorded
    /// Writer: haptic loop, at its own rate while an audible solid is touched; reader: sound. Null when nobody listens; then,
    /// and where no solid of the plan is audible, nothing is told. A full ring drops the newest: that is no fault.
    TouchRing* touches = nullptr;
    /// Both ways between haptic loop and lesson loop; null where nothing turns.
    AxleChannels* axles = nullptr;
    /// Both ways between haptic loop and the world of rigid bodies; null where there is none.
    RigidChannels* rigid = nullptr;
    /// Writer: haptic loop; reader: lesson loop, for the picture. Null where nobody asks why a force is felt.
    LatestValue<ForceShares>* shares = nullptr;
    /// Between haptic loop and kite loop; null where no kite's line is held.
    KiteChannels* kite = nullptr;

    /// Pressed by anybody: the force fades at once and stays zero until `rearm`. Released by whoever
    /// pressed it.
    StopSwitch emergency_stop;
    /// Set by anybody while the lesson has failed: the force fades, and comes back softly after it
    /// is cleared.
    std::atomic<bool> lesson_failed{false};
    /// Set by a person's explicit wish after `emergency_stop` was let go; the haptic loop takes it back when it has left the
    /// stop. A stop that comes before that takes it back too.
    std::atomic<bool> rearm{false};
    /// Set by anybody when the run is over: the force fades and stays away. Nothing has failed.
    std::atomic<bool> ended{false};
    /// Set while the stop of another hand of this run holds: as if it were this one's. Writer: the round of all hands.
    std::atomic<bool> other_stopped{false};
    /// Cleared while another hand of this run has a force or may get one, so that `emergency_stop` tells of all. Same writer.
    std::atomic<bool> others_still{true};
    /// Writer: haptic loop; reader: recorder. Null where nothing is recorded, and where the loops take turns under a virtual clock.
    ToldRings* told = nullptr;
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
