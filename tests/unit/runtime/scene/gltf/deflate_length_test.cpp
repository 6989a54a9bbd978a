#include "runtime/scene/gltf/deflate_length.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;
using namespace fulcrum::runtime::gltf;

namespace {

using Octets = std::vector<std::uint8_t>;

struct Stream {
    std::size_t length;
    Octets zlib;
};

/// Made by zlib 1.2 at level 9: dynamic codes, fixed codes, a run of zeros, stored.
const std::vector<Stream> kStreams{
    {600, {0x78, 0xDA, 0x63, 0x60, 0x62, 0x63, 0x62, 0x66, 0x63, 0x64, 0x64, 0x66,
           0x61, 0x66, 0x61, 0x61, 0x62, 0x62, 0x64, 0x65, 0x61, 0x62, 0x65, 0x66,
           0x18, 0x15, 0x1C, 0x15, 0xA4, 0x4C, 0x10, 0x00, 0x3F, 0xC9, 0x07, 0x08}},
    {33, {0x78, 0x01, 0x2B, 0xC9, 0x2F, 0x4D, 0xCE, 0x50, 0x28, 0xC1, 0x20, 0x13, 0xF3,
          0x52, 0x14, 0xCA, 0x53, 0x33, 0xD3, 0x33, 0x00, 0xD6, 0xE6, 0x0C, 0x74}},
    {5,
     {0x78, 0x01, 0x01, 0x05, 0x00, 0xFA, 0xFF, 0x68, 0x65, 0x6C, 0x6C, 0x6F, 0x06, 0x2C, 0x02,
      0x15}}};

/// 100 000 zeros in 120 bytes.
Octets zeros() {
    Octets zlib{0x78, 0xDA, 0xED, 0xC1, 0x31, 0x01, 0x00, 0x00, 0x00,
                0xC2, 0xA0, 0xF5, 0x4F, 0x6D, 0x0D, 0x0F, 0xA0};
    zlib.resize(113, 0);
    zlib.insert(zlib.end(), {0x80, 0x57, 0x03, 0x86, 0xAF, 0x00, 0x01});
    return zlib;
}

}  // namespace

TEST_CASE("deflate length: is what the stream expands to") {
    for (const Stream& stream : kStreams) {
        CHECK(inflated_length(stream.zlib, 1'000'000) == stream.length);
        CHECK(inflated_length(stream.zlib, stream.length) == stream.length);
    }
    CHECK(inflated_length(zeros(), 1'000'000) == 100'000U);
}

TEST_CASE("deflate length: stops at the limit") {
    for (const Stream& stream : kStreams) {
        CHECK_FALSE(inflated_length(stream.zlib, stream.length - 1));
    }
    CHECK_FALSE(inflated_length(zeros(), 99'999));
    CHECK_FALSE(inflated_length(zeros(), 0));
}

TEST_CASE("deflate length: a stream cut short is malformed") {
    for (const Stream& stream : kStreams) {
        // The last four bytes are the checksum, which is not read.
        for (std::size_t n = 0; n + 4 < stream.zlib.size(); ++n) {
            CAPTURE(stream.length, n);
            CHECK_FALSE(inflated_length(std::span(stream.zlib).first(n), 1'000'000));
        }
    }
}

TEST_CASE("deflate length: bad headers, block kinds and codes are malformed") {
    CHECK_FALSE(inflated_length(Octets{0x79, 0x01, 0x01, 0, 0, 0xFF, 0xFF}, 10));  // method 9
    CHECK_FALSE(inflated_length(Octets{0x78, 0x02, 0x01, 0, 0, 0xFF, 0xFF}, 10));  // check bits
    CHECK_FALSE(
        inflated_length(Octets{0x78, 0x20, 0x01, 0, 0, 0xFF, 0xFF}, 10));  // preset dictionary
    CHECK_FALSE(inflated_length(Octets{0x78, 0x01, 0x07, 0, 0, 0, 0, 0, 0}, 10));  // block kind 3
    CHECK_FALSE(
        inflated_length(Octets{0x78, 0x01, 0x01, 5, 0, 0, 0, 1, 2, 3, 4, 5}, 10));  // length check
    CHECK(inflated_length(Octets{0x78, 0x01, 0x01, 0, 0, 0xFF, 0xFF}, 10) == 0U);
    // A dynamic block whose codes are all ones: more codes than there is room for.
    CHECK_FALSE(inflated_length(Octets(40, 0xFF), 10));
    Octets dynamic{0x78, 0x01, 0x05};
    dynamic.resize(60, 0xFF);
    CHECK_FALSE(inflated_length(dynamic, 1'000'000));
}

TEST_CASE("deflate length: more codes than there is room for are malformed") {
    Octets zlib{0x78, 0x01};
    int held = 8;
    const auto put = [&](unsigned value, int n) {
        for (int i = 0; i < n; ++i, ++held) {
            if (held == 8) {
                zlib.push_back(0);
                held = 0;
            }
            zlib.back() = static_cast<std::uint8_t>(zlib.back() | (value >> i & 1U) << held);
        }
    };
    // A last, dynamic block of 257 literals and one distance, whose lengths are coded by `n` codes of one bit.
    const auto block = [&](int n) {
        zlib.resize(2);
        held = 8;
        put(5, 3);
        put(0, 5);
        put(0, 5);
        put(15, 4);
        // In the format's order 16 17 18 0 8 7 9 6 10 5 11 4 12 3 13 2 14 1 15: symbols 0 and 1 come first.
        for (int i = 0; i < 19; ++i) {
            const bool used = i == 3 || i == 17 || (n > 2 && i > 3 && i < 2 + n);
            put(used ? 1 : 0, 3);
        }
        // 256 lengths of 0, length 1 for the end of the block, length 0 for the distance; then that end.
        put(0, 32);
        for (int i = 0; i < 7; ++i) {
            put(0, 32);
        }
        put(1, 1);
        put(0, 1);
        put(0, 1);
        return inflated_length(zlib, 10);
    };
    CHECK(block(2) == 0U);
    CHECK_FALSE(block(3));
    CHECK_FALSE(block(12));
}
