#include "runtime/link/udp_socket.h"

#include "tests/unit/runtime/rig.h"

#include <chrono>
#include <thread>

using namespace fulcrum::runtime::test;

namespace {

// On this computer a packet is there within milliseconds; a second is for one that is very busy.
std::size_t receive_soon(UdpSocket& socket, std::span<std::byte> packet, PeerAddress& from) {
    for (int i = 0; i < 1000; ++i) {
        if (const std::size_t size = socket.receive(0.0, packet, from)) {
            return size;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return 0;
}

}  // namespace

TEST_CASE("udp socket: HOST:PORT is read, and what is none gets a sentence") {
    const auto plain = value_of(parse_host_port("localhost:4701"));
    CHECK(plain.host == "localhost");
    CHECK(plain.port == 4701);
    const auto six = value_of(parse_host_port("[::1]:80"));
    CHECK(six.host == "::1");
    for (const char* const bad :
         {"", ":", "localhost", "localhost:", ":4701", "localhost:0", "localhost:65536",
          "localhost:x", "localhost:12x", "::1:80", "[]:80"}) {
        INFO(bad);
        CHECK_FALSE(parse_host_port(bad));
    }
}

TEST_CASE("udp socket: packets go there and back, with whom they are from") {
    const auto arm = value_of(UdpSocket::listen({"127.0.0.1", 0}));
    REQUIRE(arm->port() != 0);
    const auto program = value_of(UdpSocket::connect({"127.0.0.1", arm->port()}));
    std::array<std::byte, 8> packet{};
    PeerAddress from;
    CHECK(arm->receive(0.0, packet, from) == 0);
    const std::array<std::byte, 4> sent{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{4}};
    CHECK(program->send(0.0, {}, sent));
    REQUIRE(receive_soon(*arm, packet, from) == 4);
    CHECK(packet[3] == std::byte{4});
    CHECK(from.size > 0);
    CHECK(arm->send(0.0, from, sent));
    PeerAddress back;
    REQUIRE(receive_soon(*program, packet, back) == 4);
    // The same peer has the same address each time; to nobody nothing goes.
    PeerAddress again;
    CHECK(program->send(0.0, {}, sent));
    REQUIRE(receive_soon(*arm, packet, again) == 4);
    CHECK(again == from);
    CHECK_FALSE(arm->send(0.0, {}, sent));
}

TEST_CASE("udp socket: a packet that is longer than there is room tells its whole size") {
    const auto arm = value_of(UdpSocket::listen({"127.0.0.1", 0}));
    const auto program = value_of(UdpSocket::connect({"127.0.0.1", arm->port()}));
    const std::array<std::byte, 600> sent{};
    CHECK(program->send(0.0, {}, sent));
    std::array<std::byte, 8> packet{};
    PeerAddress from;
    CHECK(receive_soon(*arm, packet, from) == 600);
}

TEST_CASE("udp socket: nobody there is no error, and who comes later is heard") {
    std::uint16_t port = 0;
    {
        const auto gone = value_of(UdpSocket::listen({"127.0.0.1", 0}));
        port = gone->port();
    }
    const auto program = value_of(UdpSocket::connect({"127.0.0.1", port}));
    std::array<std::byte, 8> packet{};
    PeerAddress from;
    for (int i = 0; i < 20; ++i) {
        (void)program->send(0.0, {}, packet);
        CHECK(program->receive(0.0, packet, from) == 0);
    }
    const auto arm = value_of(UdpSocket::listen({"127.0.0.1", port}));
    // The first may still meet the error of the one before.
    (void)program->send(0.0, {}, packet);
    (void)program->send(0.0, {}, packet);
    CHECK(receive_soon(*arm, packet, from) == 8);
}

TEST_CASE("udp socket: a port that is taken and a computer that nobody knows are one sentence") {
    const auto first = value_of(UdpSocket::listen({"127.0.0.1", 0}));
    check_says(error_of(UdpSocket::listen({"127.0.0.1", first->port()})).what_to_do, {"--port"});
    CHECK(error_of(UdpSocket::connect({"no such computer", 4701})).where ==
          "no such computer:4701");
}

TEST_CASE("udp socket: a port where nothing waits is told by its computer, a silent one not") {
    std::uint16_t port = 0;
    {
        const auto silent = value_of(UdpSocket::listen({"127.0.0.1", 0}));
        port = silent->port();
        const auto program = value_of(UdpSocket::connect({"127.0.0.1", port}));
        std::array<std::byte, 8> packet{};
        PeerAddress from;
        CHECK(program->send(0.0, {}, packet));
        CHECK(program->receive(0.0, packet, from) == 0);
        CHECK_FALSE(program->was_refused());
    }
    for (const bool sends_again : {false, true}) {
        const auto program = value_of(UdpSocket::connect({"127.0.0.1", port}));
        std::array<std::byte, 8> packet{};
        PeerAddress from;
        CHECK(program->send(0.0, {}, packet));
        // The answer comes with the next call, whichever that is.
        if (sends_again) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            CHECK_FALSE(program->send(0.0, {}, packet));
        }
        CHECK(program->receive(0.0, packet, from) == 0);
        CHECK(program->was_refused());
    }
}
