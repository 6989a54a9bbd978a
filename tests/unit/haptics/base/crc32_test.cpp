#include "haptics/base/crc32.h"

#include "haptics/math/split_mix.h"

#include <catch2/catch.hpp>

#include <vector>

using namespace fulcrum;

namespace {

// Bit by bit, as ISO 3309 has it.
std::uint32_t crc32_by_bits(std::span<const std::byte> bytes) {
    std::uint32_t rest = 0xFFFFFFFFU;
    for (const std::byte byte : bytes) {
        rest ^= static_cast<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            rest = (rest >> 1U) ^ ((rest & 1U) != 0 ? 0xEDB88320U : 0U);
        }
    }
    return ~rest;
}

std::vector<std::byte> random_bytes(std::size_t n) {
    SplitMix chance(n + 1);
    std::vector<std::byte> bytes(n);
    for (std::byte& byte : bytes) {
        byte = static_cast<std::byte>(chance.draw_chance() * 256.0);
    }
    return bytes;
}

}  // namespace

TEST_CASE("crc32: the check value of the standard, also in parts") {
    const char* const text = "123456789";
    const auto bytes = std::as_bytes(std::span(text, 9));
    CHECK(compute_crc32(bytes) == 0xCBF43926U);
    CHECK(compute_crc32(bytes.subspan(4), compute_crc32(bytes.first(4))) == 0xCBF43926U);
    CHECK(compute_crc32({}) == 0);
}

TEST_CASE("crc32: by products, by tables and bit by bit it is the same at every length and place") {
    const std::vector<std::byte> all = random_bytes(600);
    for (std::size_t n = 0; n <= 300; ++n) {
        const std::size_t first = n % 19;
        const auto bytes = std::span(all).subspan(first, n);
        const std::uint32_t right = crc32_by_bits(bytes);
        CAPTURE(n);
        REQUIRE(compute_crc32(bytes) == right);
        REQUIRE(compute_crc32_by_tables(bytes) == right);
    }
}

TEST_CASE("crc32: of parts, however it is cut, it is that of the whole") {
    const std::vector<std::byte> all = random_bytes(257);
    const std::uint32_t right = crc32_by_bits(all);
    for (std::size_t cut = 0; cut <= all.size(); ++cut) {
        const auto bytes = std::span(all);
        CAPTURE(cut);
        REQUIRE(compute_crc32(bytes.subspan(cut), compute_crc32(bytes.first(cut))) == right);
    }
}

TEST_CASE("crc32: one bit that is turned is told, wherever it stands") {
    std::vector<std::byte> bytes = random_bytes(300);
    const std::uint32_t right = compute_crc32(bytes);
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        const auto mask = static_cast<std::byte>(1U << (bit % 8));
        bytes[bit / 8] ^= mask;
        REQUIRE(compute_crc32(bytes) != right);
        bytes[bit / 8] ^= mask;
    }
}
