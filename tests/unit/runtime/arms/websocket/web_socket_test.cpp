#include "runtime/arms/websocket/web_socket.h"

#include "haptics/base/clock.h"
#include "tests/support/haply_wire.h"
#include "tests/support/loopback_listener.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <thread>

namespace fulcrum::runtime {
namespace {

using Heard = WebSocket::Heard;
using test_support::LoopbackGuest;
using test_support::LoopbackListener;
using test_support::take_client_frames;

double in_a_while() {
    return monotonic_now_s() + 10.0;
}

// Both ends of a line on which a WebSocket was opened; what comes right behind the answer is `behind`.
struct Opened {
    explicit Opened(const std::string& behind = {}) {
        std::thread server([&] {
            guest = listener.accept();
            const std::string head = guest.read_until("\r\n\r\n");
            (void)guest.write(test_support::answer_upgrade(head).value_or("") + behind);
        });
        auto made = WebSocket::connect(listener.port(), in_a_while());
        server.join();
        REQUIRE(made);
        client = std::move(*made);
    }
    // What the client has sent, once there is something.
    [[nodiscard]] test_support::ClientMessages heard() {
        bytes += guest.read();
        return take_client_frames(bytes);
    }
    LoopbackListener listener;
    LoopbackGuest guest{-1};
    std::unique_ptr<WebSocket> client;
    std::string bytes;
    std::string text;
};

std::string answer_with(const std::string& answer) {
    const LoopbackListener listener;
    std::thread server([&] {
        const auto guest = listener.accept();
        (void)guest.read_until("\r\n\r\n");
        (void)guest.write(answer);
    });
    const auto made = WebSocket::connect(listener.port(), in_a_while());
    server.join();
    return made ? "" : to_sentence(made.error());
}

}  // namespace

TEST_CASE("websocket: text goes both ways; every frame that is sent is masked") {
    Opened line(test_support::make_wire_text("first", {}));
    CHECK(line.client->receive(line.text, in_a_while()) == Heard::text);
    CHECK(line.text == "first");
    CHECK(line.client->receive(line.text, 0.0) == Heard::nothing);
    CHECK(line.client->send("to you", in_a_while()));
    const auto heard = line.heard();
    CHECK(heard.texts == std::vector<std::string>{"to you"});
    CHECK_FALSE(heard.was_unmasked);
    // Another mask each time: the same text does not look the same.
    CHECK(line.client->send("same", in_a_while()));
    CHECK(line.client->send("same", in_a_while()));
    std::string raw;
    while (raw.size() < 20) {
        raw += line.guest.read();
    }
    CHECK(raw.substr(0, 10) != raw.substr(10));
}

TEST_CASE("websocket: fragments are joined, and a ping among them is answered") {
    Opened line;
    CHECK(line.guest.write(test_support::make_wire_text(
        "a message in three parts", {.in_fragments = true, .pings = true, .long_lengths = true})));
    CHECK(line.client->receive(line.text, in_a_while()) == Heard::text);
    CHECK(line.text == "a message in three parts");
    std::vector<std::string> pongs;
    while (pongs.size() < 2) {
        const auto heard = line.heard();
        REQUIRE_FALSE(heard.says_goodbye);
        pongs.insert(pongs.end(), heard.pongs.begin(), heard.pongs.end());
    }
    CHECK(pongs == std::vector<std::string>{"are you there", "between"});
}

TEST_CASE(
    "websocket: goodbye, a line that is cut, and what may not be sent end it with the reason") {
    {
        Opened line;
        CHECK(line.guest.write(std::string("\x88\x02\x03\xe8", 4)));
        CHECK(line.client->receive(line.text, in_a_while()) == Heard::gone);
        CHECK(line.client->why() == "it has closed the connection");
        CHECK_FALSE(line.client->send("still there?", in_a_while()));
    }
    {
        Opened line;
        CHECK(line.guest.write(test_support::make_wire_text("half of it", {}).substr(0, 6)));
        line.guest.leave();
        CHECK(line.client->receive(line.text, in_a_while()) == Heard::gone);
        CHECK(line.client->why() == "the connection is cut off");
    }
    {
        Opened line;
        CHECK(line.guest.write(std::string("\x82\x01x", 3)));
        CHECK(line.client->receive(line.text, in_a_while()) == Heard::gone);
        CHECK(line.client->why() == "it sends bytes instead of text");
    }
    {
        // Each is answered, but a flood of them holds nobody.
        Opened line;
        std::string flood;
        for (int i = 0; i < 100; ++i) {
            flood += std::string("\x89\x00", 2);
        }
        CHECK(line.guest.write(flood));
        CHECK(line.client->receive(line.text, in_a_while()) == Heard::gone);
        CHECK(line.client->why() == "it sends pings instead of messages");
    }
    Opened line;
    line.client->close();
    CHECK(line.heard().says_goodbye);
    CHECK(line.client->receive(line.text, in_a_while()) == Heard::gone);
}

TEST_CASE("websocket: what answers as no WebSocket, or not at all, is refused in time") {
    CHECK(answer_with("HTTP/1.1 404 Not Found\r\n\r\n").find("it says 404") != std::string::npos);
    CHECK(answer_with("220 mail ready\r\n\r\n").find("no HTTP") != std::string::npos);
    CHECK(answer_with("").find("does not answer") != std::string::npos);
    CHECK(answer_with("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: "
                      "Upgrade\r\nSec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n\r\n")
              .find("nobody here asked") != std::string::npos);
    std::uint16_t port = 0;
    {
        const LoopbackListener silent;
        port = silent.port();
        CHECK(is_refused(WebSocket::connect(port, monotonic_now_s() + 0.02), "does not answer"));
    }
    CHECK(is_refused(WebSocket::connect(port, in_a_while()), "nobody listens there"));
}

}  // namespace fulcrum::runtime
