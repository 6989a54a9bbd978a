// What the arm's side must not be talked out of: late commands, whoever gives them out; limits; its own stop.
#include "tests/unit/haptics/link/held_arm.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using test_link::Engaged;
using test_link::Held;

TEST_CASE("link: good commands that somebody held back are stale, and hold the arm no longer") {
    for (const int every : {1, 50}) {
        CAPTURE(every);
        Engaged held;
        // They are kept on their way for 60 ms, then given out in order, quickly or slowly; nothing else comes.
        held.pair.tap.keeps = held.pair.tap.cut = true;
        held.run(60);
        const auto kept = held.pair.tap.sent;
        REQUIRE(kept.size() >= 50);
        held.commands = false;
        for (std::size_t i = 0; i < 30; ++i) {
            held.pair.channel.end(0).send(held.pair.now_s, {}, kept[i]);
            for (int k = 0; k < every; ++k) {
                held.run(1);
                REQUIRE(any(held.arm().faults & Fault::command_stale));
            }
        }
        held.run(every == 1 ? 600 : 0);
        CHECK(held.hand.written_D.force.norm() == 0.0);
        CHECK_FALSE(held.arm().held);
    }
}

TEST_CASE("link: a stop at the arm that is lifted while it fades fades on") {
    Engaged held;
    held.pair.server.stop();
    held.run(5);
    held.pair.server.rearm();
    double before_N = held.felt_N();
    for (int i = 0; i < 90; ++i) {
        held.run(1);
        const double now_N = held.felt_N();
        REQUIRE(before_N - now_N == Approx(0.03).epsilon(0.01));  // 3 N in 100 ms
        before_N = now_N;
    }
    held.run(20);
    CHECK(held.arm().gate == GatePhase::waiting);
}

TEST_CASE("link: a command counts from the holder's session to this one alone") {
    Engaged held;
    struct Wrong {
        std::uint64_t sender, receiver;
    };
    // Another program that has heard the arm's number; the holder, in an earlier session of the arm's; nobody in particular.
    std::uint64_t strangers = held.refused(Refusal::stranger);
    for (const Wrong& wrong : {Wrong{4242, 2000}, Wrong{1000, 1999}, Wrong{1000, 0}}) {
        LinkPacket packet;
        packet.head = {PacketKind::command,
                       wrong.sender,
                       wrong.receiver,
                       1'000'000,
                       LinkPost::to_ns(held.pair.now_s),
                       0,
                       0};
        packet.command.wrench_D.force.x() = -3.0;
        packet.command.max_force_N = 10.0;
        packet.command.max_slew_N_per_s = 500.0;
        held.send(packet);
        held.run(3);
        CHECK(held.felt_N() == Approx(3.0));
        CHECK(held.refused(Refusal::stranger) == ++strangers);
    }
}
