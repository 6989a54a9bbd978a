// One side's letters: numbers, seals and sends its packets, opens and checks what comes, and keeps the clocks compared.
//
// Accepted is what read_packet accepts, is addressed to this session, comes from the partner's session, and was not there before. Where
// the newest came from is where the partner is: who copies packets can carry them on, and win nothing by it. A number counts as taken only after all else holds, so nothing that a stranger sends can
// make a good packet refused.
//
// Thread: the loop that owns the link. Cost: about a microsecond a packet.
#pragma once

#include "haptics/link/datagrams.h"
#include "haptics/link/link_clock.h"
#include "haptics/link/link_format.h"
#include "haptics/link/replay_window.h"

#include <array>
#include <cstdint>
#include <optional>

namespace fulcrum {

/// So many packets that are lost in a row are a fault, at any rate; one fewer is none.
inline constexpr std::uint64_t kLostInARow = 20;

/// How many packets came and what became of them.
struct LinkCounts {
    std::uint64_t sent = 0;
    std::uint64_t unsent = 0;                         ///< the system took them not
    std::array<std::uint64_t, kRefusals> received{};  ///< by Refusal; those taken at Refusal::none
    /// All that were not taken.
    [[nodiscard]] std::uint64_t refused() const noexcept {
        std::uint64_t sum = 0;
        for (std::size_t i = 1; i < received.size(); ++i) {
            sum += received[i];
        }
        return sum;
    }
};

/// Draws numbers for sessions that nobody can guess; never 0. A test gives its own.
class SessionNumbers {
  public:
    SessionNumbers() = default;
    SessionNumbers(const SessionNumbers&) = delete;
    SessionNumbers& operator=(const SessionNumbers&) = delete;
    virtual ~SessionNumbers() = default;
    [[nodiscard]] virtual std::uint64_t draw() noexcept = 0;
};

/// A packet that passed all that the packet alone can tell.
struct OpenedPacket {
    LinkPacket packet{};
    PeerAddress from{};
};

class LinkPost {
  public:
    /// All must outlive the post.
    LinkPost(Datagrams& datagrams, const Seal& seal, SessionNumbers& numbers) noexcept;

    /// Forgets the partner and goes on under a new number.
    void begin_session() noexcept;
    [[nodiscard]] std::uint64_t session() const noexcept { return session_; }
    /// From now on packets count only from this session; it is answered at this address, until a newer packet comes from elsewhere.
    void set_partner(std::uint64_t session, const PeerAddress& address) noexcept;
    [[nodiscard]] bool has_partner() const noexcept { return partner_ != 0; }
    [[nodiscard]] std::uint64_t partner() const noexcept { return partner_; }

    /// In one round so many datagrams are looked at, refused ones too, so that a flood of them costs time and no more: a step ends, and
    /// what goes on is late and fades.
    static constexpr int kMostAtOnce = 256;
    /// A round begins.
    void begin_round() noexcept { left_ = kMostAtOnce; }

    /// The next packet that is whole and authentic, whoever's session it is of; refused ones are counted and passed over.
    /// Nothing when no more have come, or this round has looked at enough.
    [[nodiscard]] std::optional<OpenedPacket> open_next(double now_s) noexcept;
    /// Whether it is for this session, from the partner and new; then it is heard by the clock. Counts it either way.
    [[nodiscard]] bool accept(double now_s, const OpenedPacket& opened) noexcept;
    /// Counts it as a stranger's.
    void refuse() noexcept { ++counts_.received[static_cast<std::size_t>(Refusal::stranger)]; }

    /// Fills in the head and sends to the partner.
    void send(double now_s, LinkPacket& packet) noexcept;
    /// The same to somebody else, told in the head as `receiver`.
    void send_to(double now_s, LinkPacket& packet, std::uint64_t receiver,
                 const PeerAddress& to) noexcept;

    [[nodiscard]] const LinkClock& clock() const noexcept { return clock_; }
    [[nodiscard]] const LinkCounts& counts() const noexcept { return counts_; }
    /// Number of the newest packet taken from the partner.
    [[nodiscard]] std::uint64_t newest() const noexcept { return window_.newest(); }
    /// How many numbers before that one had not come when it came, up to the newest of then: lost, or still on their way.
    [[nodiscard]] std::uint64_t missing() const noexcept { return missing_; }
    /// When what the partner measured at `theirs_ns` arrives as usual, on the run's clock, seconds, never after `now_s`; that is
    /// `now_s` while the clocks are not compared.
    [[nodiscard]] double compute_usual_arrival_s(double now_s,
                                                 std::int64_t theirs_ns) const noexcept;
    /// This side's clock as it stands in packets.
    [[nodiscard]] static std::int64_t to_ns(double now_s) noexcept;

  private:
    Datagrams& datagrams_;
    const Seal& seal_;
    SessionNumbers& numbers_;
    std::uint64_t session_ = 0;
    std::uint64_t sequence_ = 0;
    std::uint64_t partner_ = 0;
    PeerAddress address_{};
    ReplayWindow window_{};
    LinkClock clock_{};
    std::int64_t heard_sent_ns_ = 0;     // of the newest packet taken: the partner's clock
    std::int64_t heard_arrived_ns_ = 0;  // and ours
    std::uint64_t missing_ = 0;
    LinkCounts counts_{};
    int left_ = kMostAtOnce;  // to look at in this round
    PacketBytes bytes_{};
};

}  // namespace fulcrum
