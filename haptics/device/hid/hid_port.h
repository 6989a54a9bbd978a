// The threads between a HID device and the haptic loop, which must wait for neither.
//
//   reader   opens the device · waits for reports, kReadWait_ms at most · hands over the newest state, with the time at which
//            the device was last known to be there · when it has gone, looks for it every kSearch_s, at its path or wherever it
//            comes back
//   writer   only where there is force: a link of its own · begins the effects · every kWrite_s the newest force, renewed while
//            there is nothing new · a force older than kSilence_s counts as none · when anything fails: ends the effects, and
//            begins again a moment later
// A device that takes an order in no time holds up the writer alone; `overdue_s` tells. What the device holds by then ends by itself
// (force_effects.h). Whoever leaves waits kFarewell_s at most: a thread that is still in the device's hands then ends when it comes back.
//
//   sample   LatestValue: reader thread -> haptic loop        force   LatestValue: haptic loop -> writer thread
// Thread: made, started and stopped by the lesson loop. Cost: two threads that sleep.
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/hid/force_effects.h"
#include "haptics/device/hid/hid_ability.h"
#include "haptics/device/hid/hid_link.h"
#include "haptics/device/hid/space_mouse.h"
#include "haptics/device/hid/stick.h"
#include "haptics/handover/latest_value.h"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::hid {

inline constexpr int kReadWait_ms = 4;
inline constexpr double kWrite_s = 0.002;
inline constexpr double kSilence_s = 0.02;
inline constexpr double kSearch_s = 0.25;
inline constexpr double kFarewell_s = 0.5;
inline constexpr double kBegin_s = 3.0;  ///< how long `start` waits for the first poses and forces

/// What the reader knows of the device.
struct HidSample {
    double stamp_s = 0.0;     ///< when it was there for certain, monotonic clock
    double reported_s = 0.0;  ///< when it last reported a state, likewise
    bool is_there = false;
    bool repeats_itself = false;  ///< it says the same again and again while it rests, as most do
    CapState cap{};               ///< of a SpaceMouse
    StickState stick{};           ///< of a stick
};

/// What the haptic loop wants felt.
struct HidForce {
    double stamp_s = 0.0;  ///< monotonic clock
    double x = 0.0;        ///< share of the full force to the right
    double y = 0.0;        ///< away from the user
};

/// Counted since the start, for people.
struct HidCounts {
    std::uint64_t reports = 0;
    std::uint64_t garbage = 0;  ///< reports that were of no use
    std::uint64_t losses = 0;   ///< times that the device went away
    std::uint64_t writes_failed = 0;
};

class HidPort {
  public:
    /// `node` is what `choose_hand` gave. Starts the threads and waits until poses come, and forces go where there are any; refuses
    /// a device that does not come to that within kBegin_s. `settings` are valid.
    [[nodiscard]] static Expected<std::shared_ptr<HidPort>> start(
        std::shared_ptr<HidBus> bus, const HidNode& node, const ForceEffectSettings& settings);
    HidPort(const HidPort&) = delete;
    HidPort& operator=(const HidPort&) = delete;
    ~HidPort() = default;

    /// Ends both threads, and before them what the device renders.
    void stop() noexcept;

    LatestValue<HidSample> sample;  ///< haptic loop: the reader's newest
    LatestValue<HidForce> force;    ///< haptic loop: publishes

    /// True while the device takes forces; for one without force always.
    [[nodiscard]] bool takes_force() const noexcept {
        return takes_force_.load(std::memory_order_acquire);
    }
    /// For how long the device has been taking the order that it has now; 0 when it has none.
    [[nodiscard]] double overdue_s(double now_s) const noexcept;

    [[nodiscard]] const HidAbility& ability() const noexcept { return ability_; }
    [[nodiscard]] const HidNode& node() const noexcept { return node_; }
    [[nodiscard]] HidCounts counts() const noexcept;
    /// What has happened since the last call that people should know, a sentence; empty when nothing has.
    [[nodiscard]] std::string take_notice();

  private:
    HidPort(std::shared_ptr<HidBus> bus, const HidNode& node, const ForceEffectSettings& settings);

    void run_reader();
    [[nodiscard]] std::unique_ptr<HidLink> connect();
    [[nodiscard]] Expected<std::unique_ptr<HidLink>> open_same(const HidNode& found);
    void read_until_lost(HidLink& link);
    [[nodiscard]] bool take_report(std::span<const std::uint8_t> report) noexcept;
    void note_repeat(std::span<const std::uint8_t> report) noexcept;
    void publish(bool is_there) noexcept;

    void run_writer();
    void write_until_lost(HidLink& link, ForceEffects& effects);
    [[nodiscard]] bool write_newest(HidLink& link, ForceEffects& effects);

    // Waits, and is true when the port is to stop.
    [[nodiscard]] bool pause(double seconds);
    [[nodiscard]] bool stops() const noexcept { return stops_.load(std::memory_order_acquire); }
    void tell(const std::string& sentence);
    void leave(bool& runs) noexcept;

    std::shared_ptr<HidBus> bus_;
    HidNode node_;        // as it was chosen
    HidAbility ability_;  // likewise; its descriptor outlives the effects
    ForceEffectSettings settings_;

    HidSample newest_{};              // the reader's, as are the next
    std::vector<std::uint8_t> said_;  // the last report
    int repeats_ = 0;                 // since the last long pause
    std::atomic<std::uint64_t> reports_{0};
    std::atomic<std::uint64_t> garbage_{0};
    std::atomic<std::uint64_t> losses_{0};
    std::atomic<std::uint64_t> writes_failed_{0};
    std::atomic<double> ordered_s_{0.0};  // when the order began that the device has now; 0: none
    std::atomic<bool> takes_force_{false};
    std::atomic<bool> stops_{false};

    std::mutex mutex_;  // of what follows
    std::condition_variable changed_;
    std::string path_;  // where the device is now; empty: it has gone
    std::string notice_;
    bool reader_runs_ = false;
    bool writer_runs_ = false;
};

}  // namespace fulcrum::hid
