#include "haptics/link/link_faults.h"

#include "haptics/link/memory_channel.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace fulcrum;

namespace {

// Sends numbered packets, one a millisecond, and keeps the numbers that arrive, in order of coming.
struct Line {
    explicit Line(const LinkFaults& faults) : faulty(faults, channel.end(0)) {}

    void send(int n) {
        for (int i = 0; i < n; ++i) {
            now_s += 0.001;
            std::array<std::byte, 4> packet{};
            for (std::size_t k = 0; k < 4; ++k) {
                packet[k] = static_cast<std::byte>((number >> (8 * k)) & 0xFFU);
            }
            ++number;
            faulty.send(now_s, {}, packet);
            receive();
        }
    }
    void wait(double seconds) {
        now_s += seconds;
        // What waits is passed on by any call.
        std::array<std::byte, 4> none{};
        PeerAddress from;
        (void)faulty.receive(now_s, none, from);
        receive();
    }
    void receive() {
        std::array<std::byte, 64> packet{};
        PeerAddress from;
        while (channel.end(1).receive(now_s, packet, from) > 0) {
            std::uint32_t got = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                got |= std::to_integer<std::uint32_t>(packet[k]) << (8 * k);
            }
            arrived.push_back(got);
            arrived_at_s.push_back(now_s);
        }
    }

    MemoryChannel channel;
    FaultyDatagrams faulty;
    double now_s = 0.0;
    std::uint32_t number = 0;
    std::vector<std::uint32_t> arrived;
    std::vector<double> arrived_at_s;
};

}  // namespace

TEST_CASE("link faults: without faults all comes at once and in order") {
    Line line({});
    line.send(100);
    REQUIRE(line.arrived.size() == 100);
    for (std::uint32_t i = 0; i < 100; ++i) {
        CHECK(line.arrived[i] == i);
    }
}

TEST_CASE("link faults: as much is lost as was asked for, in bursts of just that length") {
    for (const int burst : {1, 10}) {
        Line line({.loss = 0.05, .burst = burst, .seed = 2});
        line.send(200'000);
        const double lost = 1.0 - static_cast<double>(line.arrived.size()) / 200'000.0;
        CHECK(lost == Approx(0.05).epsilon(0.05));
        for (std::size_t i = 1; i < line.arrived.size(); ++i) {
            const std::uint32_t gap = line.arrived[i] - line.arrived[i - 1] - 1;
            REQUIRE((gap == 0 || gap == static_cast<std::uint32_t>(burst)));
        }
    }
}

TEST_CASE("link faults: a delay delays, jitter is within its bounds, and nothing else overtakes") {
    Line line({.delay_s = 0.02});
    line.send(500);
    line.wait(0.1);
    REQUIRE(line.arrived.size() == 500);
    for (std::uint32_t i = 0; i < 400; ++i) {
        REQUIRE(line.arrived[i] == i);
        REQUIRE(line.arrived_at_s[i] - 0.001 * (i + 1) == Approx(0.02).margin(0.0011));
    }
    Line shaky({.delay_s = 0.01, .jitter_s = 0.01, .seed = 4});
    shaky.send(5000);
    shaky.wait(0.1);
    REQUIRE(shaky.arrived.size() == 5000);
    CHECK(shaky.faulty.counts().overtaken > 1000);
    for (std::size_t i = 0; i < 4900; ++i) {
        const double way_s = shaky.arrived_at_s[i] - 0.001 * (shaky.arrived[i] + 1);
        REQUIRE(way_s >= 0.01 - 1e-9);
        REQUIRE(way_s <= 0.0211);
    }
}

TEST_CASE("link faults: each kind happens as often as asked, and is counted") {
    Line line({.reorder = 0.1, .duplicate = 0.2, .corrupt = 0.05, .seed = 6});
    line.send(20'000);
    line.wait(0.1);
    const LinkFaultCounts& counts = line.faulty.counts();
    CHECK(static_cast<double>(counts.doubled) == Approx(4000.0).epsilon(0.1));
    CHECK(static_cast<double>(counts.damaged) == Approx(0.05 * 24'000).epsilon(0.1));
    CHECK(counts.overtaken > 500);
    CHECK(line.arrived.size() == 20'000 + counts.doubled);
    CHECK(counts.passed == line.arrived.size());
    CHECK(counts.dropped == 0);
}

TEST_CASE("link faults: the same seed gives the same faults") {
    const LinkFaults faults{
        .loss = 0.1, .burst = 3, .jitter_s = 0.01, .duplicate = 0.1, .corrupt = 0.1, .seed = 9};
    Line a(faults), b(faults);
    LinkFaults other = faults;
    other.seed = 10;
    Line c(other);
    for (Line* line : {&a, &b, &c}) {
        line->send(2000);
        line->wait(0.1);
    }
    CHECK(a.arrived == b.arrived);
    CHECK(a.arrived != c.arrived);
}

TEST_CASE("link faults: what finds no room is lost and counted") {
    Line line({.delay_s = 1.0});
    for (std::size_t i = 0; i < FaultyDatagrams::kMostWaiting + 10; ++i) {
        const std::array<std::byte, 4> packet{};
        line.faulty.send(0.0, {}, packet);
    }
    CHECK(line.faulty.counts().dropped == 10);
}

TEST_CASE("link faults: settings out of range are refused") {
    CHECK(validate(LinkFaults{}));
    CHECK_FALSE(validate(LinkFaults{.loss = 1.01}));
    CHECK_FALSE(validate(LinkFaults{.loss = kNan}));
    CHECK_FALSE(validate(LinkFaults{.burst = 0}));
    CHECK_FALSE(validate(LinkFaults{.delay_s = -0.1}));
    CHECK_FALSE(validate(LinkFaults{.corrupt = 1.1}));
}
