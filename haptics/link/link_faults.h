// A channel that loses, delays, mixes up, doubles and damages packets, as told: for trying and testing, never in a lesson.
//
// Every packet that is sent, and every one that has come, goes this way:
//   lost       in bursts of exactly `burst`, with at least one packet between two, so that a part `loss` of all is lost
//   delayed    by delay_s + U(0, jitter_s); what overtakes another stays overtaken
//   reordered  with probability `reorder`, by a further U(0, 4 ms)
//   doubled    with probability `duplicate`, the second after a delay of its own
//   damaged    with probability `corrupt`, one to eight of its bits turned over
// The same seed and the same calls give the same faults.
//
// Thread: its owner's. Cost: a copy a packet; kMostWaiting of them wait at most, and what comes then is lost and counted.
// Source: bursts after E. N. Gilbert 1960, Capacity of a burst-noise channel, Bell System Technical Journal 39(5), with bursts
// of a fixed length, so that "bursts of ten" means that.
#pragma once

#include "haptics/base/error.h"
#include "haptics/link/datagrams.h"
#include "haptics/math/split_mix.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fulcrum {

struct LinkFaults {
    double loss = 0.0;      ///< part that is lost, 0 to 1; 1 is a cable that was pulled
    int burst = 1;          ///< packets lost one after another, 1 to 1000
    double delay_s = 0.0;   ///< each way, 0 to 1
    double jitter_s = 0.0;  ///< 0 to 1
    double reorder = 0.0;   ///< probabilities, 0 to 1
    double duplicate = 0.0;
    double corrupt = 0.0;
    std::uint64_t seed = 1;
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const LinkFaults& faults);

/// How often each kind has happened, both ways together.
struct LinkFaultCounts {
    std::uint64_t passed = 0;
    std::uint64_t lost = 0;
    std::uint64_t delayed = 0;
    std::uint64_t overtaken = 0;
    std::uint64_t doubled = 0;
    std::uint64_t damaged = 0;
    std::uint64_t dropped = 0;  ///< for want of room
};

class FaultyDatagrams final : public Datagrams {
  public:
    static constexpr std::size_t kMostWaiting = 4096;  ///< each way
    static constexpr std::size_t kMostBytes = 512;     ///< a packet's

    /// Takes faults that `validate` accepted; `inner` must outlive the channel.
    FaultyDatagrams(const LinkFaults& faults, Datagrams& inner);
    ~FaultyDatagrams() override;

    bool send(double now_s, const PeerAddress& to,
              std::span<const std::byte> packet) noexcept override;
    [[nodiscard]] std::size_t receive(double now_s, std::span<std::byte> packet,
                                      PeerAddress& from) noexcept override;

    /// Other faults from now on; the seed and what waits stay.
    void set(const LinkFaults& faults) noexcept { faults_ = faults; }
    [[nodiscard]] const LinkFaultCounts& counts() const noexcept { return counts_; }

  private:
    struct Waiting {
        double due_s = 0.0;
        std::uint64_t number = 0;
        PeerAddress peer{};
        std::size_t size = 0;
        std::array<std::byte, kMostBytes> bytes{};
    };
    // One way: packets by their due times, and whether it is in the middle of a burst.
    struct Way {
        std::vector<Waiting> waiting;  // of kMostWaiting, n of them in use
        std::size_t n = 0;
        int burst_left = 0;
        std::uint64_t until_burst = 0;
        bool has_gap = false;
        std::uint64_t number = 0;
        double latest_due_s = 0.0;
    };

    void enter(Way& way, double now_s, const PeerAddress& peer,
               std::span<const std::byte> packet) noexcept;
    void wait(Way& way, double due_s, const PeerAddress& peer, std::span<const std::byte> packet,
              bool damages) noexcept;
    [[nodiscard]] bool loses(Way& way) noexcept;
    [[nodiscard]] Waiting* find_due(Way& way, double now_s) noexcept;
    static void remove(Way& way, Waiting& gone) noexcept;
    void pass_on(double now_s) noexcept;
    [[nodiscard]] bool happens(double probability) noexcept {
        return chance_.draw_chance() < probability;
    }

    LinkFaults faults_;
    Datagrams& inner_;
    SplitMix chance_;
    Way out_;
    Way in_;
    LinkFaultCounts counts_{};
    std::array<std::byte, kMostBytes> bytes_{};
};

}  // namespace fulcrum
