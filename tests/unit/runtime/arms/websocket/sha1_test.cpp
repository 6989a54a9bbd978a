#include "runtime/arms/websocket/sha1.h"

#include <catch2/catch.hpp>

#include <cstdio>

namespace fulcrum::runtime {
namespace {

std::string hex_of(const Sha1Digest& digest) {
    std::string text;
    for (const std::uint8_t byte : digest) {
        char two[3];
        (void)std::snprintf(two, sizeof two, "%02x", static_cast<unsigned>(byte));
        text += two;
    }
    return text;
}

}  // namespace

TEST_CASE("sha1: the four tests of RFC 3174, section 7.3") {
    CHECK(hex_of(compute_sha1("abc")) == "a9993e364706816aba3e25717850c26c9cd0d89d");
    CHECK(hex_of(compute_sha1("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")) ==
          "84983e441c3bd26ebaae4aa1f95129e5e54670f1");
    CHECK(hex_of(compute_sha1(std::string(1'000'000, 'a'))) ==
          "34aa973cd4c4daa4f61eeb2bdbad27316534016f");
    std::string digits;
    for (int i = 0; i < 80; ++i) {
        digits += "01234567";
    }
    CHECK(hex_of(compute_sha1(digits)) == "dea356a2cddd90c7a7ecedc5ebb563934f460452");
}

TEST_CASE("sha1: nothing, and a length at each side of where a block is full") {
    CHECK(hex_of(compute_sha1("")) == "da39a3ee5e6b4b0d3255bfef95601890afd80709");
    // The length needs eight bytes and the one a ninth: 55 fit into a block, 56 do not.
    CHECK(hex_of(compute_sha1(std::string(55, 'a'))) == "c1c8bbdc22796e28c0e15163d20899b65621d65a");
    CHECK(hex_of(compute_sha1(std::string(56, 'a'))) == "c2db330f6083854c99d4b5bfb6e8f29f201be699");
    CHECK(hex_of(compute_sha1(std::string(64, 'a'))) == "0098ba824b5c16427bd7a1122a5a442a25ec644d");
}

}  // namespace fulcrum::runtime
