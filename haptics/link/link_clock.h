// What the other side's clock shows, and how long a packet is under way, from the four times that every exchange gives.
//
//   T1 this side sent, T2 the other heard, T3 the other sent, T4 this side heard:
//   round trip delta = (T4 - T1) - (T3 - T2),   offset theta = ((T2 - T1) + (T3 - T4)) / 2   (theirs - ours)
// A packet carries T3, T1 (echoed) and T3 - T2 (held). A wait in a queue makes delta longer and theta wrong by at most half of
// it, so the exchange with the least delta tells most: it is kept for kSpan_s, then a newer one takes its place, so that clocks
// that drift (1e-4 at worst) are followed within 0.5 ms. Nothing can tell a way there from a way back: theta may be off by half
// of their difference.
//   usual arrival of what was sent at t (theirs) = t - theta + delta / 2   of the best exchange: lateness counts from it.
//
// Thread: the loop that owns the link. Cost: a few nanoseconds.
// Source: RFC 5905, network time protocol version 4, section 8 (on-wire protocol, theta and delta) and section 10 (clock
// filter: the sample of least delay among the newest).
#pragma once

#include <cstdint>

namespace fulcrum {

class LinkClock {
  public:
    static constexpr double kSpan_s = 5.0;  ///< an exchange is kept for one to two of these

    /// Takes one exchange, all in nanoseconds: T3 on the other's clock, T1 and T4 on ours. One that cannot be (a round trip
    /// below zero or above a minute) is not taken.
    void hear(std::int64_t sent_theirs_ns, std::int64_t echoed_ours_ns, std::int64_t held_ns,
              std::int64_t arrived_ours_ns) noexcept;
    void reset() noexcept { *this = LinkClock{}; }

    /// False until an exchange was taken.
    [[nodiscard]] bool is_known() const noexcept { return best_.known || before_.known; }
    /// Theirs minus ours of the best exchange, seconds; off by at most half of the round trip.
    [[nodiscard]] double offset_s() const noexcept;
    /// Of the best exchange, seconds.
    [[nodiscard]] double round_trip_s() const noexcept;
    /// Of the newest one.
    [[nodiscard]] double newest_round_trip_s() const noexcept { return newest_round_trip_s_; }
    /// When, on our clock, what was sent at `theirs_ns` arrives as usual.
    [[nodiscard]] std::int64_t usual_arrival_ns(std::int64_t theirs_ns) const noexcept;

  private:
    struct Exchange {
        bool known = false;
        std::int64_t offset_ns = 0;
        std::int64_t round_trip_ns = 0;
    };
    [[nodiscard]] const Exchange& best() const noexcept;

    Exchange best_{};    // of this span
    Exchange before_{};  // of the one before
    std::int64_t span_began_ns_ = 0;
    double newest_round_trip_s_ = 0.0;
};

}  // namespace fulcrum
