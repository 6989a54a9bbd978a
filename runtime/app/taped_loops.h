// The loops of a plan once more, told what a tape holds (run_tape.h): the hand's device gives the poses that were, and keeps what it is sent.
//
//   round k of a tape:  reading, stops -> each hand's loop;  then, when due, the effects, as under the virtual clock
// Of the plan that was run they give what it gave, to the bit. Of another plan they say what that would have given the same hand.
//
// Thread: one. No allocation in `step` after construction, but for a world's commands that wait.
#pragma once

#include "haptics/loop/haptic_loop.h"
#include "runtime/app/hand_channels.h"
#include "runtime/app/run_effects.h"
#include "runtime/app/run_tape.h"
#include "runtime/scene/plan.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace fulcrum::runtime {

/// Gives what it is given.
class TapedDevice final : public Device {
  public:
    explicit TapedDevice(DeviceTraits traits) : traits_(std::move(traits)) {}
    /// Of the next round; false: none was read in it.
    void put(const DeviceReading& reading, bool is_read) noexcept;
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;

  private:
    DeviceTraits traits_;
    DeviceReading reading_{};
    bool is_read_ = false;
};

/// One hand's loop with channels of its own.
class TapedHand {
  public:
    /// `has_rigid`: the run has a world of rigid bodies.
    TapedHand(const HapticPlan& plan, const DeviceTraits& traits, bool has_rigid);
    /// The round with these faults from outside, and a reading.
    void step(const TapedRound& round, const DeviceReading& reading, double now_s) noexcept;
    /// Tells it what another hand's loop took in its last round, and that one had not told before.
    void hear(const TapedHand& other) noexcept;

    [[nodiscard]] const HapticLoop& loop() const noexcept { return *loop_; }
    [[nodiscard]] HapticLoop& loop() noexcept { return *loop_; }
    [[nodiscard]] HapticChannels& channels() noexcept { return *channels_; }
    [[nodiscard]] const HapticChannels& channels() const noexcept { return *channels_; }

  private:
    std::unique_ptr<TapedDevice> device_;
    std::unique_ptr<HandChannels> channels_;
    std::unique_ptr<HapticLoop> loop_;
    std::array<std::uint64_t, 5> heard_{};  // of each channel of the other
    bool was_stopped_ = false;
};

class TapedLoops {
  public:
    /// Of a plan whose parts `validate` accepted; `first` is what its world is told before the first frame.
    [[nodiscard]] static Expected<std::unique_ptr<TapedLoops>> create(
        const Plan& plan, const std::vector<DeviceTraits>& hands,
        const std::vector<WorldCommand>& first);

    /// The next round, with the frames that come before it.
    void step(const RunTape& tape) noexcept;
    [[nodiscard]] const TapedHand& hand(std::size_t hand) const { return *hands_[hand]; }
    [[nodiscard]] std::size_t n_hands() const noexcept { return hands_.size(); }

  private:
    TapedLoops(const Plan& plan, const std::vector<DeviceTraits>& hands);
    void tell(const TapedFrame& frame);
    void step_effects(double now_s) noexcept;

    Plan plan_;
    std::vector<std::unique_ptr<TapedHand>> hands_;
    RunEffects effects_;
    std::size_t round_ = 0;
    std::size_t frame_ = 0;
};

}  // namespace fulcrum::runtime
