#include "haptics/link/link_clock.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

constexpr std::int64_t kMs = 1'000'000;

// One exchange between clocks that differ by `offset_ns`: there, held, back.
void exchange(LinkClock& clock, std::int64_t at_ns, std::int64_t there_ns, std::int64_t held_ns,
              std::int64_t back_ns, std::int64_t offset_ns) {
    const std::int64_t theirs_sent = at_ns + there_ns + held_ns + offset_ns;
    clock.hear(theirs_sent, at_ns, held_ns, at_ns + there_ns + held_ns + back_ns);
}

}  // namespace

TEST_CASE("link clock: even ways give offset and round trip exactly") {
    LinkClock clock;
    CHECK_FALSE(clock.is_known());
    exchange(clock, 100 * kMs, 3 * kMs, 7 * kMs, 3 * kMs, 123456 * kMs);
    REQUIRE(clock.is_known());
    CHECK(clock.offset_s() == Approx(123.456).epsilon(1e-12));
    CHECK(clock.round_trip_s() == Approx(0.006).epsilon(1e-12));
    // Sent at 200 ms of ours, it arrives 3 ms later.
    CHECK(clock.usual_arrival_ns(200 * kMs + 123456 * kMs) == 203 * kMs);
    // Clocks whose zeros are the other way round.
    LinkClock behind;
    exchange(behind, 500'000 * kMs, kMs, 0, kMs, -400'000 * kMs);
    CHECK(behind.offset_s() == Approx(-400.0).epsilon(1e-12));
}

TEST_CASE("link clock: an uneven way is wrong by half of what it is uneven, and not more") {
    LinkClock clock;
    exchange(clock, 0 + kMs, 9 * kMs, 0, kMs, 0);
    CHECK(clock.offset_s() == Approx(0.004).epsilon(1e-9));
    CHECK(std::abs(clock.offset_s()) <= clock.round_trip_s() / 2.0);
}

TEST_CASE("link clock: what waited in a queue does not count beside what did not") {
    LinkClock clock;
    for (int i = 1; i <= 1000; ++i) {
        const bool is_quick = i % 97 == 0;
        exchange(clock, i * kMs, is_quick ? kMs : 20 * kMs, 0, is_quick ? kMs : 3 * kMs, 55 * kMs);
    }
    CHECK(clock.round_trip_s() == Approx(0.002).epsilon(1e-9));
    CHECK(clock.offset_s() == Approx(0.055).epsilon(1e-9));
    CHECK(clock.newest_round_trip_s() == Approx(0.023).epsilon(1e-9));
}

TEST_CASE("link clock: clocks that drift are followed") {
    LinkClock clock;
    double worst_s = 0.0;
    for (std::int64_t i = 1; i <= 100'000; ++i) {
        const std::int64_t at_ns = i * kMs;
        const std::int64_t offset_ns = at_ns / 10'000;  // 1e-4
        exchange(clock, at_ns, kMs, 0, kMs, offset_ns);
        worst_s =
            std::max(worst_s, std::abs(clock.offset_s() - static_cast<double>(offset_ns) * 1e-9));
    }
    CHECK(worst_s < 1.1e-4 * 2.0 * LinkClock::kSpan_s);
}

TEST_CASE("link clock: a way that has become longer for good is learned within two spans") {
    LinkClock clock;
    std::int64_t at_ns = kMs;
    for (; at_ns < 3000 * kMs; at_ns += kMs) {
        exchange(clock, at_ns, kMs, 0, kMs, 0);
    }
    for (; at_ns < 14'000 * kMs; at_ns += kMs) {
        exchange(clock, at_ns, 30 * kMs, 0, 30 * kMs, 0);
    }
    CHECK(clock.round_trip_s() == Approx(0.060).epsilon(1e-9));
}

TEST_CASE("link clock: exchanges that cannot be are not taken") {
    LinkClock clock;
    clock.hear(5 * kMs, 0, 0, 10 * kMs);               // nothing echoed
    clock.hear(5 * kMs, 20 * kMs, 0, 10 * kMs);        // back before it went
    clock.hear(5 * kMs, 5 * kMs, 20 * kMs, 10 * kMs);  // held for longer than it took
    clock.hear(5 * kMs, kMs, 0, 100'000 * kMs);        // a minute and more
    CHECK_FALSE(clock.is_known());
}
