// Packets lost in a row, at 1 and 2 kHz, on either way: ten and nineteen are borne, twenty trip.
#include "tests/unit/haptics/link/held_arm.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <span>

using namespace fulcrum;
using namespace fulcrum::test_link;

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

}  // namespace

TEST_CASE("link loss: nineteen in a row are borne and twenty trip, at 1 and 2 kHz, either way") {
    for (const double rate_Hz : {1000.0, 2000.0}) {
        for (int phase = 0; phase < 20; ++phase) {
            for (const int n : {1, 10, 19, 20, 21, 30}) {
                if (phase >= kPhases && (n != 20 || rate_Hz != 1000.0)) {
                    continue;  // the border is tried at more moments
                }
                CAPTURE(rate_Hz, phase, n);
                const bool trips = n >= 20;
                Rated there(rate_Hz);
                there.lose(&Hole::loses_out, n, phase, 0.1);
                CHECK(there.server.status().trips == (trips ? 1 : 0));
                Rated back(rate_Hz);
                back.lose(&Hole::loses_in, n, phase, 0.1);
                CHECK((back.n_stale > 0) == trips);
            }
        }
    }
}

TEST_CASE("link loss: at 500 Hz ten in a row are more than 20 ms, and trip, either way") {
    for (int phase = 0; phase < kPhases; ++phase) {
        for (const int n : {1, 8, 10, 11}) {
            CAPTURE(phase, n);
            const bool trips = n >= 10;
            Rated there(500.0);
            there.lose(&Hole::loses_out, n, phase, 0.2);
            CHECK(there.server.status().trips == (trips ? 1 : 0));
            // The program looks at its own rate, which is 1 kHz.
            Rated back(1000.0, {}, 2);
            back.lose(&Hole::loses_in, n, phase, 0.2);
            CHECK((back.n_stale > 0) == trips);
        }
    }
}

TEST_CASE("link loss: an arm at 500 Hz bears ten commands at 1 kHz, and eight of its states") {
    for (int phase = 0; phase < kPhases; ++phase) {
        for (const int n : {8, 10, 18, 21, 30}) {
            CAPTURE(phase, n);
            Rated there(1000.0, {}, 2);
            there.lose(&Hole::loses_out, n, phase, 0.2);
            CHECK(there.server.status().trips == (n >= 20 ? 1 : 0));
        }
        Rated back(1000.0, {}, 2);
        back.lose(&Hole::loses_in, 8, phase, 0.2);
        CHECK(back.n_stale == 0);
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
