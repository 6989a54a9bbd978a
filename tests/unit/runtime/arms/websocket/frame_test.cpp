#include "runtime/arms/websocket/frame.h"

#include <catch2/catch.hpp>

#include <initializer_list>

namespace fulcrum::runtime {
namespace {

using Got = FrameReader::Got;

std::string bytes(std::initializer_list<int> values) {
    std::string all;
    for (const int value : values) {
        all += static_cast<char>(value);
    }
    return all;
}

// A server's frame, which is not masked; the length in as many bytes as `more` says.
std::string frame(int first, const std::string& payload, int more = 0) {
    std::string all = bytes({first});
    const auto size = payload.size();
    all += static_cast<char>(more == 8 ? 127 : more == 2 ? 126 : static_cast<int>(size));
    for (int i = more - 1; i >= 0; --i) {
        all += static_cast<char>((size >> (8U * static_cast<unsigned>(i))) & 0xffU);
    }
    return all + payload;
}

std::string why_broken(const std::string& sent) {
    FrameReader reader;
    reader.feed(sent);
    CHECK(reader.next() == Got::broken);
    // For good.
    reader.feed(frame(0x81, "Hello"));
    CHECK(reader.next() == Got::broken);
    return std::string(reader.why());
}

}  // namespace

TEST_CASE("websocket frame: the examples of RFC 6455, section 5.7") {
    // A masked text message "Hello", and a masked pong of the same.
    std::string sent;
    append_frame(Opcode::text, "Hello", {0x37, 0xfa, 0x21, 0x3d}, sent);
    CHECK(sent == bytes({0x81, 0x85, 0x37, 0xfa, 0x21, 0x3d, 0x7f, 0x9f, 0x4d, 0x51, 0x58}));
    sent.clear();
    append_frame(Opcode::pong, "Hello", {0x37, 0xfa, 0x21, 0x3d}, sent);
    CHECK(sent == bytes({0x8a, 0x85, 0x37, 0xfa, 0x21, 0x3d, 0x7f, 0x9f, 0x4d, 0x51, 0x58}));

    FrameReader reader;
    reader.feed(bytes({0x81, 0x05, 0x48, 0x65, 0x6c, 0x6c, 0x6f}));
    CHECK(reader.next() == Got::text);
    CHECK(reader.payload() == "Hello");
    CHECK(reader.next() == Got::nothing);
    // Two fragments, and a ping between them.
    reader.feed(bytes({0x01, 0x03, 0x48, 0x65, 0x6c}));
    reader.feed(bytes({0x89, 0x05, 0x48, 0x65, 0x6c, 0x6c, 0x6f}));
    reader.feed(bytes({0x80, 0x02, 0x6c, 0x6f}));
    CHECK(reader.next() == Got::ping);
    CHECK(reader.payload() == "Hello");
    CHECK(reader.next() == Got::text);
    CHECK(reader.payload() == "Hello");
}

TEST_CASE("websocket frame: a length has 7, 16 or 64 bits, at both sides of each bound") {
    for (const std::size_t size : {0U, 125U, 126U, 65535U, 65536U, 1U << 20U}) {
        CAPTURE(size);
        const std::string payload(size, 'x');
        std::string sent;
        append_frame(Opcode::text, payload, {0, 0, 0, 0}, sent);
        const std::size_t more = size < 126 ? 0 : size < 65536 ? 2 : 8;
        CHECK(sent.size() == 2 + more + 4 + size);
        FrameReader reader;
        reader.feed(frame(0x81, payload, static_cast<int>(more)));
        REQUIRE(reader.next() == Got::text);
        CHECK(reader.payload() == payload);
    }
    // More bytes of length than are needed do no harm.
    FrameReader reader;
    reader.feed(frame(0x81, "short", 8));
    CHECK(reader.next() == Got::text);
}

TEST_CASE("websocket frame: it comes out the same in whatever pieces it comes in") {
    const std::string all = frame(0x01, "one ") + frame(0x89, "") + frame(0x00, "two ") +
                            frame(0x80, "three") + frame(0x81, std::string(300, 'y'), 2) +
                            frame(0x8a, "late") + frame(0x88, bytes({0x03, 0xe8}));
    FrameReader reader;
    std::vector<Got> got;
    std::vector<std::string> told;
    for (const char byte : all) {
        reader.feed({&byte, 1});
        for (Got next = reader.next(); next != Got::nothing; next = reader.next()) {
            got.push_back(next);
            told.push_back(reader.payload());
        }
    }
    CHECK(got == std::vector{Got::ping, Got::text, Got::text, Got::pong, Got::close});
    REQUIRE(told.size() == 5);
    CHECK(told[1] == "one two three");
    CHECK(told[2] == std::string(300, 'y'));
    CHECK(told[4] == bytes({0x03, 0xe8}));
}

TEST_CASE("websocket frame: what a server may not send ends it, each with its reason") {
    CHECK(why_broken(bytes({0x81, 0x85, 1, 2, 3, 4, 0, 0, 0, 0, 0})).find("mask") !=
          std::string::npos);
    CHECK(why_broken(frame(0x82, "Hello")).find("bytes") != std::string::npos);
    CHECK(why_broken(frame(0xc1, "Hello")).find("extension") != std::string::npos);
    CHECK(why_broken(frame(0x83, "Hello")).find("kind") != std::string::npos);
    CHECK(why_broken(frame(0x8b, "Hello")).find("kind") != std::string::npos);
    CHECK(why_broken(frame(0x09, "part")).find("control") != std::string::npos);
    CHECK(why_broken(frame(0x89, std::string(126, 'p'), 2)).find("control") != std::string::npos);
    CHECK(why_broken(frame(0x80, "no beginning")).find("disorder") != std::string::npos);
    CHECK(why_broken(frame(0x01, "begun") + frame(0x81, "again")).find("disorder") !=
          std::string::npos);
}

TEST_CASE("websocket frame: a message of parts without end is refused, though they are empty") {
    const auto in_parts = [](int n) {
        std::string sent = frame(0x01, "");
        for (int i = 2; i < n; ++i) {
            sent += frame(0x00, "");
        }
        return sent + frame(0x80, "end");
    };
    FrameReader reader;
    reader.feed(in_parts(kMostParts));
    CHECK(reader.next() == Got::text);
    // Counted anew for each.
    reader.feed(in_parts(kMostParts));
    CHECK(reader.next() == Got::text);
    CHECK(why_broken(in_parts(kMostParts + 1)) == "it sends a message in too many parts");
}

TEST_CASE("websocket frame: too large a message is refused by its head, whole or in parts") {
    CHECK(why_broken(bytes({0x81, 127, 0, 0, 0, 0, 0, 0x10, 0, 1})).find("megabyte") !=
          std::string::npos);
    CHECK(why_broken(bytes({0x81, 127, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff}))
              .find("megabyte") != std::string::npos);
    const std::string half(kMostMessageBytes / 2 + 1, 'h');
    CHECK(why_broken(frame(0x01, half, 8) + frame(0x80, half, 8)).find("megabyte") !=
          std::string::npos);
}

}  // namespace fulcrum::runtime
