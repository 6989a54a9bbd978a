#include "tests/unit/haptics/link/held_arm.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <random>

using namespace fulcrum;
using test_link::Engaged;
using test_link::Held;

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
                LinkPacket forged;
                forged.head = {
                    PacketKind::command, 1000, 2000, 1'000'000'000 + random() % 1000, 1, 0, 0};
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
    // The arm's own packets come back to it, as from a mirror.
    LinkPacket state;
    state.head = {PacketKind::state, 1000, 2000, 1'000'000, 1, 0, 0};
    PacketBytes bytes{};
    const std::size_t size = write_packet(state, held.pair.seal, bytes);
    const auto before = held.refused(Refusal::stranger);
    held.pair.channel.end(0).send(0.0, {}, std::span(bytes).first(size));
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
