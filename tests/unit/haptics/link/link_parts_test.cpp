#include "haptics/link/link_clock.h"
#include "haptics/link/memory_channel.h"
#include "haptics/link/replay_window.h"
#include "haptics/link/seen_way.h"
#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/link/held_arm.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <rapidcheck.h>
#include <set>
#include <vector>

using namespace fulcrum;
using test_link::Engaged;
using test_link::Held;

namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr double kRound_s = 0.001;

// One exchange between clocks that differ by `offset_ns`: there, held, back.
void exchange(LinkClock& clock, std::int64_t at_ns, std::int64_t there_ns, std::int64_t held_ns,
              std::int64_t back_ns, std::int64_t offset_ns) {
    const std::int64_t theirs_sent = at_ns + there_ns + held_ns + offset_ns;
    clock.hear(theirs_sent, at_ns, held_ns, at_ns + there_ns + held_ns + back_ns);
}

std::vector<std::byte> packet_of(std::size_t size, unsigned first) {
    std::vector<std::byte> packet(size);
    for (std::size_t i = 0; i < size; ++i) {
        packet[i] = static_cast<std::byte>(first + i);
    }
    return packet;
}

Vector3 along(double x) {
    return {x, 0.0, 0.0};
}

}  // namespace

TEST_CASE(
    "link clock: even ways give offset and round trip exactly, uneven ones half of the odds") {
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
    clock = LinkClock();
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

TEST_CASE("link clock: clocks that drift are followed, a longer way is learned within two spans") {
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
    clock = LinkClock();
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

TEST_CASE("link: nothing forged, flipped or replayed is taken, and no good one refused after it") {
    // The short form; tests/README.md has the long one.
    const char* const asked = std::getenv("FULCRUM_FORGED_PACKETS");
    const int n = asked != nullptr ? std::atoi(asked) : 60'000;
    Held held;
    held.pair.tap.keeps = true;
    held.engage();
    held.pair.tap.keeps = false;
    auto kept = held.pair.tap.sent;
    // An old hello may be answered, for it changes nothing.
    std::erase_if(
        kept, [](const auto& packet) { return packet.size() != packet_size(PacketKind::command); });
    REQUIRE(kept.size() > 3000);
    std::mt19937_64 random(1);
    const auto taken_before = held.refused(Refusal::none);
    std::uint64_t good = 0;
    std::uint64_t bad = 0;
    const test_link::HmacSeal other(99);
    for (int i = 0; i < n; ++i) {
        std::vector<std::byte> packet = kept[random() % kept.size()];
        switch (i % 4) {
            case 0:  // one bit turned over
                packet[random() % packet.size()] ^= std::byte{1} << (random() % 8);
                break;
            case 1:  // as it was
                break;
            case 2: {  // all new, sealed with another key, numbered far ahead
                LinkPacket forged = test_link::make_numbered(
                    PacketKind::command, {1000, 2000, 1'000'000'000 + random() % 1000});
                forged.command.wrench_D.force = {-10.0, 0.0, 0.0};
                forged.command.max_force_N = 10.0;
                forged.command.max_slew_N_per_s = 500.0;
                PacketBytes bytes{};
                const std::size_t size = write_packet(forged, other, bytes);
                packet.assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
                break;
            }
            default:  // noise of any length
                packet.resize(1 + random() % 400);
                for (std::byte& byte : packet) {
                    byte = static_cast<std::byte>(random());
                }
        }
        held.pair.channel.end(0).send(held.pair.now_s, {}, packet);
        ++bad;
        if (i % 20 == 19) {
            held.run(1);
            ++good;
            REQUIRE(held.felt_N() == Approx(3.0));
        }
    }
    held.run(50);
    good += 50;
    // Exactly the program's own packets were taken.
    CHECK(held.refused(Refusal::none) - taken_before == good);
    const LinkCounts counts = held.arm().counts;
    std::uint64_t all_refused = 0;
    for (std::size_t why = 1; why < kRefusals; ++why) {
        all_refused += counts.received[why];
    }
    CHECK(all_refused == bad);
    CHECK(held.arm().trips == 0);
    CHECK(held.arm().sessions == 1);
}

TEST_CASE("link: packets of an earlier session are a stranger's in the next") {
    Held held;
    held.pair.tap.keeps = true;
    held.engage();
    const auto kept = held.pair.tap.sent;
    held.pair.tap.keeps = false;
    held.pair.tap.cut = true;
    held.run(700);
    // Nobody holds the arm. Whoever kept the packets plays them all.
    for (const auto& packet : kept) {
        held.pair.channel.end(0).send(held.pair.now_s, {}, packet);
        held.run(1);
        REQUIRE(held.hand.written_D.force.norm() == 0.0);
        REQUIRE_FALSE(held.arm().held);
    }
    held.pair.tap.cut = false;
    held.wrench = {};
    held.run(200);
    CHECK(held.gives_pose);
}

TEST_CASE("link: what an arm says, sent back to it, is refused") {
    Engaged held;
    const auto before = held.refused(Refusal::stranger);
    held.send(test_link::make_numbered(PacketKind::state, {1000, 2000, 1'000'000}));
    held.run(1);
    CHECK(held.refused(Refusal::stranger) == before + 1);
    CHECK(held.arm().held);
}

TEST_CASE("link: an order that has been overtaken is not carried out") {
    Held held({.jitter_s = 0.010, .reorder = 0.5, .seed = 5});
    REQUIRE(held.pair.link(2.0));
    held.run(300);
    // The force asked for only ever grows; so does what is felt.
    double felt = 0.0;
    for (int i = 0; i < 3000; ++i) {
        held.wrench.force.x() = 1e-3 * i;
        held.run(1);
        REQUIRE(held.felt_N() >= felt - 1e-12);
        felt = held.felt_N();
    }
    CHECK(held.pair.faulty.counts().overtaken > 1000);
    CHECK(felt > 2.0);
}

TEST_CASE("memory channel: what one end sends the other has at once and in order, both ways") {
    MemoryChannel channel;
    std::array<std::byte, MemoryChannel::kMostBytes> bytes{};
    std::array<PeerAddress, 2> from;
    for (const int sender : {0, 1}) {
        Datagrams& to = channel.end(1 - sender);
        for (unsigned i = 0; i < 10; ++i) {
            REQUIRE(channel.end(sender).send(0.0, {}, packet_of(20 + i, i)));
        }
        for (unsigned i = 0; i < 10; ++i) {
            PeerAddress& peer = from[static_cast<std::size_t>(sender)];
            REQUIRE(to.receive(0.0, bytes, peer) == 20 + i);
            const std::vector<std::byte> right = packet_of(20 + i, i);
            REQUIRE(std::equal(right.begin(), right.end(), bytes.begin()));
        }
        CHECK(to.receive(0.0, bytes, from[0]) == 0);
        CHECK(channel.end(sender).receive(0.0, bytes, from[0]) == 0);  // nobody hears himself
    }
    CHECK_FALSE(from[0] == from[1]);
    CHECK(from[0].size > 0);
}

TEST_CASE("memory channel: a packet is cut to the room there is, and its whole size told") {
    MemoryChannel channel;
    REQUIRE(channel.end(0).send(0.0, {}, packet_of(100, 7)));
    std::array<std::byte, 60> bytes{};
    std::array<std::byte, 40> few{};
    PeerAddress from;
    CHECK(channel.end(1).receive(0.0, few, from) == 100);
    CHECK(few[39] == static_cast<std::byte>(46));
    CHECK(channel.end(1).receive(0.0, bytes, from) == 0);
}

TEST_CASE("memory channel: what is too long or finds no room does not go, and the rest stays") {
    MemoryChannel channel;
    CHECK_FALSE(channel.end(0).send(0.0, {}, packet_of(MemoryChannel::kMostBytes + 1, 0)));
    for (std::size_t i = 0; i < MemoryChannel::kMostWaiting; ++i) {
        REQUIRE(channel.end(0).send(0.0, {}, packet_of(1 + i % 9, 1)));
    }
    CHECK_FALSE(channel.end(0).send(0.0, {}, packet_of(3, 1)));
    std::array<std::byte, MemoryChannel::kMostBytes> bytes{};
    PeerAddress from;
    REQUIRE(channel.end(1).receive(0.0, bytes, from) == 1);
    CHECK(channel.end(0).send(0.0, {}, packet_of(11, 1)));
    for (std::size_t i = 1; i < MemoryChannel::kMostWaiting; ++i) {
        REQUIRE(channel.end(1).receive(0.0, bytes, from) == 1 + i % 9);
    }
    CHECK(channel.end(1).receive(0.0, bytes, from) == 11);
    CHECK(channel.end(1).receive(0.0, bytes, from) == 0);
}

TEST_CASE(
    "replay window: each number once, in any order, as far as it reaches, up to the largest") {
    ReplayWindow window;
    CHECK_FALSE(window.take(0));
    CHECK(window.take(5));
    CHECK_FALSE(window.take(5));
    CHECK(window.take(3));
    CHECK(window.take(5 + ReplayWindow::kReach));
    CHECK_FALSE(window.take(5));  // now too old
    CHECK(window.take(6));        // the oldest that may still come
    CHECK_FALSE(window.take(6));
    CHECK(window.newest() == 5 + ReplayWindow::kReach);
    window = ReplayWindow();
    const std::uint64_t last = ~std::uint64_t{0};
    CHECK(window.take(1));
    CHECK(window.take(last));
    CHECK_FALSE(window.take(last));
    CHECK(window.take(last - 1));
    CHECK_FALSE(window.take(1));
}

TEST_CASE("replay window: agrees with a set of all numbers that were taken") {
    CHECK(rc::check("replay window", [] {
        ReplayWindow window;
        std::set<std::uint64_t> taken;
        std::uint64_t newest = 0;
        const auto steps = *rc::gen::container<std::vector<std::uint64_t>>(
            400, rc::gen::inRange<std::uint64_t>(0, 700));
        std::uint64_t base = 0;
        for (const std::uint64_t step : steps) {
            // Sometimes far on, mostly near the newest.
            base += step == 699 ? 100'000 : step % 7;
            const std::uint64_t number = base + step > 350 ? base + step - 350 : 0;
            const bool is_new = number != 0 && !taken.contains(number) &&
                                (number > newest || newest - number < ReplayWindow::kReach);
            RC_ASSERT(window.take(number) == is_new);
            if (is_new) {
                taken.insert(number);
                newest = std::max(newest, number);
            }
        }
    }));
}

TEST_CASE("seen way: a steady way has its velocity, in uneven rounds and of joints in turn") {
    SeenWay way;
    CHECK(way.velocity().isZero(0.0));
    for (const double dt_s : {0.001, 0.001, 0.004, 0.0005, 0.002}) {
        way.step(along(0.1 * dt_s), dt_s);
        CHECK(way.velocity().x() == Approx(0.1).epsilon(1e-12));
    }
    way = SeenWay();
    // Along x + y, one axis at a time.
    for (int i = 0; i < 100; ++i) {
        way.step(i % 2 == 0 ? Vector3(1e-4, 0.0, 0.0) : Vector3(0.0, 1e-4, 0.0), kRound_s);
    }
    const Vector3 direction = way.velocity().normalized();
    CHECK(direction.x() > 0.5);
    CHECK(direction.y() > 0.5);
}

TEST_CASE("seen way: between an encoder's steps it goes on, with the true velocity on average") {
    SeenWay way;
    double sum = 0.0;
    int n = 0;
    double gone_m = 0.0;
    double shown_m = 0.0;
    for (int i = 0; i < 2000; ++i) {
        gone_m += 0.02 * kRound_s;
        const double step_m = 5.5e-5 * std::floor((gone_m - shown_m) / 5.5e-5);
        shown_m += step_m;
        way.step(along(step_m), kRound_s);
        if (i >= 100) {
            CHECK(way.velocity().x() > 0.0);
            sum += way.velocity().x();
            ++n;
        }
    }
    CHECK(sum / n == Approx(0.02).epsilon(0.02));
}

TEST_CASE("seen way: it turns round within three rounds, rests after 50 ms, takes no nonsense") {
    SeenWay way;
    for (int i = 0; i < 100; ++i) {
        way.step(along(1e-4), kRound_s);
    }
    for (int i = 0; i < 3; ++i) {
        way.step(along(-1e-4), kRound_s);
    }
    CHECK(way.velocity().x() < 0.0);
    for (int i = 0; i < 51; ++i) {
        CHECK((i >= 49 || way.velocity().x() < 0.0));
        way.step(along(0.0), kRound_s);
    }
    CHECK(way.velocity().isZero(0.0));
    way.step(along(1e-4), kRound_s);
    const Vector3 before = way.velocity();
    way.step(along(kNan), kRound_s);
    way.step(along(1.0), 0.0);
    way.step(along(1.0), kNan);
    CHECK(way.velocity() == before);
    way.reset();
    CHECK(way.velocity().isZero(0.0));
}
