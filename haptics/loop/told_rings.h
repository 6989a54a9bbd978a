// Keeps what a haptic loop is told in each round, for the record of a run whose loops keep their own time.
//
//   round k: each channel of which the loop took a newer value -> (k, value) -> its ring -> recorder
// Where the loops take turns under a virtual clock nothing need be kept: what they tell each other comes again by itself.
//
// Thread: `keep` the haptic loop's; `pop` the recorder's; made before the loop. Cost: a comparison a channel, a copy where it is newer. No
// allocation after construction; of a channel that is not there, none at all.
#pragma once

#include "haptics/handover/channels.h"
#include "haptics/handover/line_state.h"
#include "haptics/handover/told.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace fulcrum {

inline constexpr std::size_t kToldRingCapacity =
    2048;  ///< of each; two seconds of a world at 1 kHz

template <class T>
using ToldRing = EventRing<Told<T>, kToldRingCapacity>;

class ToldRings {
  public:
    /// Of these channels, which outlive it. Channels that are made later are not kept.
    explicit ToldRings(const HapticChannels& channels);
    ~ToldRings();
    ToldRings(const ToldRings&) = delete;
    ToldRings& operator=(const ToldRings&) = delete;

    /// The round `tick` has taken what it was told. False when something was lost because a ring was full.
    [[nodiscard]] bool keep(std::uint64_t tick, const ToldReading& reading) noexcept;

    /// Gives all that waits to `take(const Told<T>&)`, kind by kind, each in the order of rounds.
    template <class Take>
    void drain(const Take& take) {
        const auto pop_all = [&](auto& ring) {
            if (ring) {
                for (auto& told = ring->told; ring->ring.pop(told);) {
                    take(told);
                }
            }
        };
        pop_all(command_);
        pop_all(world_);
        pop_all(axles_);
        pop_all(rigid_);
        pop_all(line_);
        pop_all(reading_);
    }
    /// Any thread: how much was lost.
    [[nodiscard]] std::uint64_t dropped() const noexcept;

  private:
    template <class T>
    struct Kept {
        ToldRing<T> ring{};
        std::uint64_t n_seen = 0;  // haptic loop's: of the channel's values
        Told<T> told{};            // recorder's
    };
    template <class T>
    static bool keep_newer(std::uint64_t tick, const LatestValue<T>& from, Kept<T>& kept) noexcept;

    const HapticChannels& channels_;
    std::unique_ptr<Kept<ForceCommand>> command_;
    std::unique_ptr<Kept<WorldFrame>> world_;
    std::unique_ptr<Kept<AxleOrders>> axles_;
    std::unique_ptr<Kept<RigidFrame>> rigid_;
    std::unique_ptr<Kept<LineState>> line_;
    std::unique_ptr<Kept<ToldReading>> reading_;
};

}  // namespace fulcrum
