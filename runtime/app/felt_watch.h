// For how much of a run's time a force is felt, of all of it and of what the lesson can give one in:
//
//   can be felt   nothing is broken that must take it away, no fault is told, no stop is on, the lesson lives; and there is something to touch,
//                 or the scene asks for a force and the gate is open: one that waits under a weight nobody can let go of
//   felt          more than kLeastFelt_N are on the hand
//
// Thread: the virtual clock's. Cost: some nanoseconds a round.
#pragma once

#include "haptics/handover/messages.h"
#include "haptics/math/felt.h"

#include <array>
#include <cstdint>

namespace fulcrum::runtime {

/// Rounds of the first hand.
struct FeltRounds {
    std::uint64_t all = 0;
    std::uint64_t possible = 0;                       ///< in which a force can be felt
    std::uint64_t felt = 0;                           ///< of those
    std::array<std::uint64_t, kToolLacks> lacking{};  ///< steps of the tool, by ToolLack
    WorldEffort world{};
    FeltRounds& operator+=(const FeltRounds& other) noexcept {
        all += other.all;
        possible += other.possible;
        felt += other.felt;
        world.n_steps += other.world.n_steps;
        world.n_unconverged += other.world.n_unconverged;
        for (std::size_t i = 0; i < kToolLacks; ++i) {
            lacking[i] += other.lacking[i];
        }
        return *this;
    }
    /// Of what is possible; 0 where nothing is.
    [[nodiscard]] double share() const noexcept {
        return possible > 0 ? static_cast<double>(felt) / static_cast<double>(possible) : 0.0;
    }
};

class FeltWatch {
  public:
    /// A round of the hands has ended. `may_feel`: nothing is broken, at the arm or around it, that must take a force away; `sees_thing`: there is
    /// something to touch.
    void hands_stepped(const HapticState& state, double felt_N, bool may_feel,
                       bool sees_thing) noexcept {
        const bool lets_through = state.gate == GatePhase::rising || state.gate == GatePhase::open;
        const bool asks = state.commanded_W.force.norm() > kLeastFelt_N;
        const bool can_be =
            may_feel && !any(state.faults) &&
            (lets_through ? sees_thing || asks : sees_thing && state.gate == GatePhase::waiting);
        ++rounds_.all;
        rounds_.possible += can_be ? 1 : 0;
        rounds_.felt += can_be && felt_N > kLeastFelt_N ? 1 : 0;
        for (std::size_t i = 0; i < kToolLacks; ++i) {
            rounds_.lacking[i] += state.tool.lacks[i] ? 1 : 0;
        }
    }
    void world_stepped(const WorldEffort& effort) noexcept { rounds_.world = effort; }
    [[nodiscard]] const FeltRounds& rounds() const noexcept { return rounds_; }

  private:
    FeltRounds rounds_{};
};

}  // namespace fulcrum::runtime
