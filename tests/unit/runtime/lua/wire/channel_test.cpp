#include "runtime/lua/wire/channel.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstring>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

using Result = Channel::Result;

struct Pair {
    std::array<int, 2> ends{-1, -1};
    Pair() {
        REQUIRE(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) == 0);
        fcntl(ends[0], F_SETFL, O_NONBLOCK);
        fcntl(ends[1], F_SETFL, O_NONBLOCK);
    }
    ~Pair() {
        close(ends[0]);
        close(ends[1]);
    }
};

Bytes print_message(const std::string& text) {
    Bytes bytes;
    encode(PrintCommand{text}, bytes);
    return bytes;
}

TEST_CASE("channel: messages come whole and in order, however they are cut") {
    const Pair pair;
    Channel receiver(pair.ends[0], 1000);
    Bytes stream = print_message("one");
    const Bytes two = print_message("two");
    stream.insert(stream.end(), two.begin(), two.end());
    RawMessage message;
    std::vector<std::string> got;
    for (const std::uint8_t byte : stream) {
        REQUIRE(send(pair.ends[1], &byte, 1, 0) == 1);
        if (receiver.receive(message) == Result::message) {
            got.push_back(decode_print(message.body)->text);
        }
    }
    CHECK(got == std::vector<std::string>{"one", "two"});
    // Both at once: the second is there without another read.
    CHECK(Channel(pair.ends[1], 1000).send(stream) == stream.size());
    REQUIRE(receiver.receive(message) == Result::message);
    CHECK(decode_print(message.body)->text == "one");
    REQUIRE(receiver.receive(message) == Result::message);
    CHECK(decode_print(message.body)->text == "two");
    CHECK(receiver.receive(message) == Result::nothing);
}

TEST_CASE("channel: a length or kind that can't be is malformed, a closed end is closed") {
    const auto result_of = [](std::uint32_t length, std::uint8_t kind) {
        const Pair pair;
        Bytes bytes(5);
        std::memcpy(bytes.data(), &length, sizeof(length));
        bytes[4] = kind;
        CHECK(Channel(pair.ends[1], 1000).send(bytes) == 5U);
        RawMessage message;
        return Channel(pair.ends[0], 1000).receive(message);
    };
    CHECK(result_of(1, 0) == Result::message);
    CHECK(result_of(2, 0) == Result::nothing);
    CHECK(result_of(0, 0) == Result::malformed);
    CHECK(result_of(1001, 0) == Result::malformed);
    CHECK(result_of(0xFFFFFFFFU, 0) == Result::malformed);
    CHECK(result_of(1, 8) == Result::malformed);
    Pair pair;
    close(pair.ends[1]);
    RawMessage message;
    CHECK(Channel(pair.ends[0], 1000).receive(message) == Result::closed);
    CHECK_FALSE(Channel(pair.ends[0], 1000).send(print_message("x")));  // and no signal kills us
    pair.ends[1] = -1;
}

TEST_CASE("channel: what the socket does not take is told") {
    const Pair pair;
    const Bytes much(8U << 20U);
    const auto sent = Channel(pair.ends[0], 1000).send(much);
    REQUIRE(sent);
    CHECK(*sent > 0);
    CHECK(*sent < much.size());
}

}  // namespace
}  // namespace fulcrum::runtime
