#include "runtime/arms/websocket/loopback_socket.h"

#include "haptics/base/clock.h"
#include "tests/support/loopback_listener.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using Received = LoopbackSocket::Received;
using test_support::LoopbackListener;

constexpr double kSoon_s = 5.0;

}  // namespace

TEST_CASE("loopback socket: what is sent at one end comes out at the other") {
    const LoopbackListener listener;
    LoopbackSocket line = LoopbackSocket::begin(listener.port());
    REQUIRE(line.is_connected(monotonic_now_s() + kSoon_s));
    const auto guest = listener.accept();
    CHECK(line.send("question", monotonic_now_s() + kSoon_s) == 8);
    CHECK(guest.read_until("question") == "question");
    CHECK(guest.write("answer"));
    std::string got = "so far: ";
    CHECK(line.receive(got, monotonic_now_s() + kSoon_s) == Received::some);
    CHECK(got == "so far: answer");
}

TEST_CASE("loopback socket: nothing waits beyond its deadline") {
    const LoopbackListener listener;
    LoopbackSocket line = LoopbackSocket::begin(listener.port());
    REQUIRE(line.is_connected(monotonic_now_s() + kSoon_s));
    const auto guest = listener.accept();
    std::string got;
    const double begun_s = monotonic_now_s();
    CHECK(line.receive(got, 0.0) == Received::nothing);
    CHECK(line.receive(got, begun_s + 0.02) == Received::nothing);
    CHECK(monotonic_now_s() >= begun_s + 0.02);
    // Nobody reads: some goes into the system's buffers, and the rest does not go.
    const std::string much(64U << 20U, 'm');
    CHECK(line.send(much, monotonic_now_s() + 0.02) < much.size());
    CHECK(monotonic_now_s() < begun_s + kSoon_s);
}

TEST_CASE("loopback socket: nobody there, and somebody who leaves, are told apart from silence") {
    std::uint16_t port = 0;
    {
        const LoopbackListener listener;
        port = listener.port();
        LoopbackSocket line = LoopbackSocket::begin(port);
        REQUIRE(line.is_connected(monotonic_now_s() + kSoon_s));
        auto guest = listener.accept();
        CHECK(guest.write("last words"));
        guest.leave();
        std::string got;
        CHECK(line.receive(got, monotonic_now_s() + kSoon_s) == Received::some);
        CHECK(line.receive(got, monotonic_now_s() + kSoon_s) == Received::closed);
        CHECK_FALSE(line.is_open());
        CHECK(line.send("more", monotonic_now_s() + kSoon_s) == 0);
    }
    LoopbackSocket line = LoopbackSocket::begin(port);
    CHECK_FALSE(line.is_connected(monotonic_now_s() + kSoon_s));
    CHECK_FALSE(LoopbackSocket().is_connected(0.0));
}

}  // namespace fulcrum::runtime
