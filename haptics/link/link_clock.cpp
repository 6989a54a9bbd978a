#include "haptics/link/link_clock.h"

namespace fulcrum {
namespace {

constexpr std::int64_t kLongestTrip_ns = 60'000'000'000;
constexpr auto kSpan_ns = static_cast<std::int64_t>(LinkClock::kSpan_s * 1.0e9);

}  // namespace

void LinkClock::hear(std::int64_t sent_theirs_ns, std::int64_t echoed_ours_ns, std::int64_t held_ns,
                     std::int64_t arrived_ours_ns) noexcept {
    const std::int64_t trip_ns = arrived_ours_ns - echoed_ours_ns - held_ns;
    if (echoed_ours_ns == 0 || trip_ns < 0 || trip_ns > kLongestTrip_ns) {
        return;
    }
    newest_round_trip_s_ = static_cast<double>(trip_ns) * 1.0e-9;
    if (!is_known()) {
        span_began_ns_ = arrived_ours_ns;
    } else if (arrived_ours_ns - span_began_ns_ >= kSpan_ns) {
        before_ = best_;
        best_ = Exchange{};
        span_began_ns_ = arrived_ours_ns;
    }
    if (!best_.known || trip_ns < best_.round_trip_ns) {
        // (T2 - T1 + T3 - T4) / 2 = T3 - T4 + delta / 2.
        best_ = {true, sent_theirs_ns - arrived_ours_ns + trip_ns / 2, trip_ns};
    }
}

// The better of both spans; what is old yields to what is only a little worse, for clocks drift.
const LinkClock::Exchange& LinkClock::best() const noexcept {
    constexpr std::int64_t kDrift_ns = 100'000;  // of 1e-5 in two spans
    const bool old_is_better =
        before_.known && (!best_.known || before_.round_trip_ns + kDrift_ns < best_.round_trip_ns);
    return old_is_better ? before_ : best_;
}

double LinkClock::offset_s() const noexcept {
    return static_cast<double>(best().offset_ns) * 1.0e-9;
}

double LinkClock::round_trip_s() const noexcept {
    return static_cast<double>(best().round_trip_ns) * 1.0e-9;
}

std::int64_t LinkClock::usual_arrival_ns(std::int64_t theirs_ns) const noexcept {
    const Exchange& exchange = best();
    return theirs_ns - exchange.offset_ns + exchange.round_trip_ns / 2;
}

}  // namespace fulcrum
