#include "haptics/link/memory_channel.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <vector>

using namespace fulcrum;

namespace {

std::vector<std::byte> packet_of(std::size_t size, unsigned first) {
    std::vector<std::byte> packet(size);
    for (std::size_t i = 0; i < size; ++i) {
        packet[i] = static_cast<std::byte>(first + i);
    }
    return packet;
}

}  // namespace

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
