#include "runtime/arms/websocket/sha1.h"

#include <bit>
#include <cstddef>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kShaBlock = 64;

using ShaState = std::array<std::uint32_t, 5>;

// FIPS 180-4, 4.1.1 and 4.2.1: the function and the constant of step t.
std::uint32_t mix_sha_words(std::size_t t, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    switch (t / 20) {
        case 0:
            return ((b & c) | (~b & d)) + 0x5a827999U;
        case 1:
            return (b ^ c ^ d) + 0x6ed9eba1U;
        case 2:
            return ((b & c) | (b & d) | (c & d)) + 0x8f1bbcdcU;
        default:
            return (b ^ c ^ d) + 0xca62c1d6U;
    }
}

// 6.1.2.
void take_sha_block(const std::array<std::uint8_t, kShaBlock>& block, ShaState& h) {
    std::array<std::uint32_t, 80> w{};
    for (std::size_t t = 0; t < 16; ++t) {
        for (std::size_t i = 0; i < 4; ++i) {
            w[t] = (w[t] << 8U) | block[4 * t + i];
        }
    }
    for (std::size_t t = 16; t < w.size(); ++t) {
        w[t] = std::rotl(w[t - 3] ^ w[t - 8] ^ w[t - 14] ^ w[t - 16], 1);
    }
    auto [a, b, c, d, e] = h;
    for (std::size_t t = 0; t < w.size(); ++t) {
        const std::uint32_t next = std::rotl(a, 5) + mix_sha_words(t, b, c, d) + e + w[t];
        e = d;
        d = c;
        c = std::rotl(b, 30);
        b = a;
        a = next;
    }
    h = {h[0] + a, h[1] + b, h[2] + c, h[3] + d, h[4] + e};
}

}  // namespace

Sha1Digest compute_sha1(std::string_view bytes) noexcept {
    ShaState h{0x67452301U, 0xefcdab89U, 0x98badcfeU, 0x10325476U, 0xc3d2e1f0U};
    std::array<std::uint8_t, kShaBlock> block{};
    std::size_t n = 0;
    const auto put = [&](std::uint8_t byte) {
        block[n++] = byte;
        if (n == kShaBlock) {
            take_sha_block(block, h);
            n = 0;
        }
    };
    for (const char byte : bytes) {
        put(static_cast<std::uint8_t>(byte));
    }
    // 5.1.1: a one, zeros, and the length in bits at the end of a block.
    put(0x80);
    while (n != kShaBlock - 8) {
        put(0);
    }
    const std::uint64_t bits = 8 * static_cast<std::uint64_t>(bytes.size());
    for (int shift = 56; shift >= 0; shift -= 8) {
        put(static_cast<std::uint8_t>(bits >> static_cast<unsigned>(shift)));
    }
    Sha1Digest digest{};
    for (std::size_t i = 0; i < digest.size(); ++i) {
        digest[i] = static_cast<std::uint8_t>(h[i / 4] >> (24U - 8U * (i % 4)));
    }
    return digest;
}

}  // namespace fulcrum::runtime
