// All that the loops of a run under a virtual clock were told from outside, so that they can be run again beside other loops: each round what
// the hands' devices told, each frame what the lesson ordered. Worlds, kites and hands' pushes follow from that by themselves.
//
//   frame -> before the round that comes next        round k -> reading, faults, gate, what was sent, of each hand
// The first kMostTapedRounds rounds are kept.
//
// Thread: that of the virtual clock.
#pragma once

#include "haptics/device/device.h"
#include "haptics/handover/messages.h"
#include "runtime/lesson/session.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace fulcrum {
class HapticLoop;
}

namespace fulcrum::runtime {

/// A minute at 1 kHz.
inline constexpr std::size_t kMostTapedRounds = 60'000;

/// Of one hand in one round.
struct TapedRound {
    DeviceReading reading{};     ///< the newest that was a pose
    Fault faults = Fault::none;  ///< all of the round
    GatePhase gate = GatePhase::waiting;
    Wrench applied_W{};
};

/// What the lesson ordered in one frame.
struct TapedFrame {
    std::size_t round = 0;  ///< before it
    ForceCommand command{};
    EffectOrders orders{};
};

class RunTape {
  public:
    explicit RunTape(std::vector<DeviceTraits> hands) : hands_(std::move(hands)) {}

    void keep_frame(const SessionOutput& output);
    /// A round has ended; `loops` are those of the hands, as many as there are traits.
    void keep_round(const std::vector<const HapticLoop*>& loops);

    [[nodiscard]] const std::vector<DeviceTraits>& hands() const { return hands_; }
    [[nodiscard]] std::size_t n_rounds() const { return rounds_.size() / hands_.size(); }
    [[nodiscard]] const TapedRound& round(std::size_t round, std::size_t hand) const {
        return rounds_[round * hands_.size() + hand];
    }
    [[nodiscard]] const std::vector<TapedFrame>& frames() const { return frames_; }

  private:
    std::vector<DeviceTraits> hands_;
    std::vector<TapedRound> rounds_;  // hand by hand
    std::vector<TapedFrame> frames_;
};

}  // namespace fulcrum::runtime
