#include "haptics/link/link_faults.h"
#include "haptics/link/memory_channel.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/link_trial.h"
#include "tests/unit/haptics/link/held_arm.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::test_link;
using test_link::LinkCourse;
using test_link::LinkTrial;
using test_link::run_link_trial;

namespace {

constexpr int kPhases = 7;

// Loses the next so many packets on either way.
class Hole final : public Datagrams {
  public:
    explicit Hole(Datagrams& inner) : inner_(inner) {}
    bool send(double now_s, const PeerAddress& to,
              std::span<const std::byte> packet) noexcept override {
        if (loses_out > 0) {
            --loses_out;
            return true;
        }
        return inner_.send(now_s, to, packet);
    }
    [[nodiscard]] std::size_t receive(double now_s, std::span<std::byte> packet,
                                      PeerAddress& from) noexcept override {
        std::size_t size = inner_.receive(now_s, packet, from);
        for (; size > 0 && loses_in > 0; --loses_in) {
            size = inner_.receive(now_s, packet, from);
        }
        return size;
    }
    int loses_out = 0;  ///< commands
    int loses_in = 0;   ///< states

  private:
    Datagrams& inner_;
};

// Both sides at one rate, or an arm that has a round in `every` of the program's, and a program that asks for 3 N.
struct Rated {
    explicit Rated(double rate_Hz, const LinkFaults& faults = {}, int every = 1)
        : step_s(1.0 / rate_Hz),
          arm_every(every),
          faulty(faults, channel.end(0)),
          hole(faulty),
          server({.rate_Hz = rate_Hz / every}, hand, channel.end(1), seal, arm_numbers),
          device({}, hole, seal, program_numbers) {
        for (int i = 0; i < 4000 && !device.status().linked; ++i) {
            step();
        }
        run(0.3);
        wrench.force.x() = 3.0;
        run(3.0);
        REQUIRE(hand.written_D.force.x() == Approx(3.0));
        n_stale = 0;
    }
    void step() {
        now_s += step_s;
        if (++n_steps % arm_every == 0) {
            server.step(now_s);
        }
        DeviceReading reading;
        const bool reads = device.read(now_s, reading);
        // As the haptic loop judges it.
        const bool is_late = now_s - reading.stamp_s > SafetySettings{}.device_timeout_s;
        n_stale += !reads || is_late || any(reading.faults & Fault::device_stale) ? 1 : 0;
        (void)device.write(now_s, wrench);
    }
    // So many packets in a row are lost on one way, some milliseconds into a round or other.
    void lose(int Hole::*which, int n, int phase, double seconds) {
        run(0.0137 * phase);
        hole.*which = n;
        run(seconds);
        CHECK(hole.*which == 0);
    }
    void run(double seconds) {
        const double until_s = now_s + seconds - 0.5 * step_s;
        while (now_s < until_s) {
            step();
        }
    }

    double step_s;
    int arm_every;
    int n_steps = 0;
    double now_s = 0.0;
    ScriptedDevice hand;
    HmacSeal seal;
    CountedNumbers program_numbers{1000};
    CountedNumbers arm_numbers{2000};
    MemoryChannel channel;
    FaultyDatagrams faulty;
    Hole hole;
    ArmServer server;
    LinkDevice device;
    Wrench wrench{};
    int n_stale = 0;  ///< rounds in which the loop would fade
};

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

constexpr double kTorque_Nm = 0.2;
constexpr double kStill_rad = 2.0e-3;

LinkTrial make_trial(double stiffness_N_per_m, const LinkFaults& faults) {
    LinkTrial trial{.stiffness_N_per_m = stiffness_N_per_m, .faults = faults};
    trial.wam.emplace();
    trial.torque_Nm = kTorque_Nm;
    return trial;
}

}  // namespace

// Packets lost in a row, at 1 and 2 kHz, on either way: ten and nineteen are borne, twenty trip.

// Packets lost in a row: what is held for 20 ms bears ten and nineteen at 1 and 2 kHz and no twenty; of half as many rounds, half as many.
TEST_CASE("link loss: nineteen in a row are borne and twenty trip, at 500 Hz ten, either way") {
    struct Way {
        double rate_Hz;
        int arm_every;
        int Hole::*loses;
        int trip;
        std::vector<int> tried;
    };
    const auto there = &Hole::loses_out;
    const auto back = &Hole::loses_in;
    const std::vector<int> many{1, 10, 19, 20, 21, 30};
    // Each side looks at its own rate: an arm of 500 Hz at the commands of 1 kHz, a program of 1 kHz at an arm's 500 Hz.
    for (const Way& way :
         {Way{1000.0, 1, there, 20, many}, Way{1000.0, 1, back, 20, many},
          Way{2000.0, 1, there, 20, many}, Way{2000.0, 1, back, 20, many},
          Way{500.0, 1, there, 10, {1, 8, 10, 11}}, Way{1000.0, 2, back, 10, {1, 8, 10, 11}},
          Way{1000.0, 2, there, 20, {8, 10, 18, 21, 30}}}) {
        for (int phase = 0; phase < 20; ++phase) {
            for (const int n : way.tried) {
                if (phase >= kPhases && (n != 20 || way.rate_Hz != 1000.0)) {
                    continue;  // the border is tried at more moments
                }
                CAPTURE(way.rate_Hz, way.arm_every, phase, n);
                Rated rated(way.rate_Hz, {}, way.arm_every);
                rated.lose(way.loses, n, phase, 0.2);
                const std::uint64_t trips = rated.server.status().trips;
                const std::uint64_t tripped = way.loses == there  ? trips
                                              : rated.n_stale > 0 ? 1U
                                                                  : 0U;
                CHECK(tripped == (n >= way.trip ? 1U : 0U));
            }
        }
    }
}

TEST_CASE("link loss: a twentieth of all in bursts of ten, or packets 4 ms late, are borne") {
    for (const double rate_Hz : {1000.0, 2000.0}) {
        for (const LinkFaults& faults :
             {LinkFaults{.loss = 0.05, .burst = 10, .seed = 3},
              LinkFaults{.jitter_s = 0.004, .reorder = 0.5, .seed = 8}}) {
            CAPTURE(rate_Hz, faults.loss);
            Rated rated(rate_Hz, faults);
            rated.run(60.0);
            const LinkFaultCounts& counts = rated.faulty.counts();
            CHECK((faults.loss > 0.0 ? counts.lost > 5000 : counts.overtaken > 20'000));
            CHECK(rated.server.status().trips == 0);
            CHECK(rated.n_stale == 0);
            CHECK(rated.hand.written_D.force.x() == Approx(3.0));
        }
    }
}

TEST_CASE("link loss: welcomes that an arm says to others are no states that were lost") {
    Rated rated(1000.0);
    // A swarm of programs that say hello from elsewhere: each gets its welcome under the arm's numbers.
    CountedNumbers others(50'000);
    for (int i = 0; i < 400; ++i) {
        for (int k = 0; k < 8; ++k) {
            send_packet(rated.channel.end(0), rated.seal,
                        make_hello(others.draw(), LinkPost::to_ns(rated.now_s)), rated.now_s);
        }
        // Ten in a row of all that comes are two rounds or so.
        rated.hole.loses_in = i % 40 == 0 ? 36 : rated.hole.loses_in;
        rated.step();
    }
    CHECK(rated.n_stale == 0);
    CHECK(rated.server.status().trips == 0);
}

TEST_CASE(
    "link faults: without any all comes at once, in order; the same seed gives the same faults") {
    Line clear({});
    clear.send(100);
    REQUIRE(clear.arrived.size() == 100);
    for (std::uint32_t i = 0; i < 100; ++i) {
        CHECK(clear.arrived[i] == i);
    }
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

TEST_CASE("link faults: what finds no room is lost and counted; bad settings are refused") {
    Line line({.delay_s = 1.0});
    for (std::size_t i = 0; i < FaultyDatagrams::kMostWaiting + 10; ++i) {
        const std::array<std::byte, 4> packet{};
        line.faulty.send(0.0, {}, packet);
    }
    CHECK(line.faulty.counts().dropped == 10);
    CHECK(validate(LinkFaults{}));
    CHECK_FALSE(validate(LinkFaults{.loss = 1.01}));
    CHECK_FALSE(validate(LinkFaults{.loss = kNan}));
    CHECK_FALSE(validate(LinkFaults{.burst = 0}));
    CHECK_FALSE(validate(LinkFaults{.delay_s = -0.1}));
    CHECK_FALSE(validate(LinkFaults{.corrupt = 1.1}));
}

// An arm of seven joints, which turns the hand as well, over the link in closed loop.

TEST_CASE("link: a wall and a torque on an arm of seven joints stay calm, whatever the line does") {
    const LinkFaults lines[] = {
        {},
        {.delay_s = 0.01},
        {.delay_s = 0.02, .jitter_s = 0.003, .reorder = 0.1},
        {.loss = 0.05, .burst = 10, .delay_s = 0.002, .duplicate = 0.1, .corrupt = 0.01}};
    for (const LinkFaults& line : lines) {
        for (const double stiffness : {200.0, 800.0}) {
            const LinkCourse course = run_link_trial(make_trial(stiffness, line));
            INFO("delay " << line.delay_s << " s, " << stiffness << " N/m: " << course.swing_m
                          << " m, " << course.turn_swing_rad << " rad, " << course.given_J << " J, "
                          << course.peak_N << " N, " << course.peak_Nm << " Nm");
            REQUIRE(course.linked);
            CHECK(course.is_calm());
            CHECK(course.turn_swing_rad < kStill_rad);
            CHECK(course.given_J < 0.1);
            CHECK(course.trips == 0);
            CHECK(course.peak_N <= 10.0);
            // It is turned, and no more than is asked for.
            CHECK(course.peak_Nm > 0.9 * kTorque_Nm);
            CHECK(course.peak_Nm < 0.3);
        }
    }
}

TEST_CASE("link: without dry friction in its joints hand and wall meet where two springs do") {
    LinkTrial trial = make_trial(300.0, {});
    for (ArmLink& link : trial.wam->model.links) {
        link.dry_friction_Nm = 0.0;
    }
    const LinkCourse course = run_link_trial(trial);
    const double hand = trial.wam->grip.push.stiffness_N_per_m;
    const double meet_N =
        trial.press_m * hand * trial.stiffness_N_per_m / (hand + trial.stiffness_N_per_m);
    // Its elbow comes home slowly against viscous friction, and has not quite in two seconds.
    constexpr double kOnItsWay = 0.1;
    REQUIRE(course.linked);
    CHECK(-course.force_N == Approx(meet_N).epsilon(kOnItsWay));
}
