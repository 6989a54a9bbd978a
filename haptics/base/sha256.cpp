#include "haptics/base/sha256.h"

#include <algorithm>
#include <bit>

namespace fulcrum {
namespace {

constexpr std::array<std::uint32_t, 64> kRounds{
    0x428a2f98U, 0x71374491U, 0xb5c0fbcfU, 0xe9b5dba5U, 0x3956c25bU, 0x59f111f1U, 0x923f82a4U,
    0xab1c5ed5U, 0xd807aa98U, 0x12835b01U, 0x243185beU, 0x550c7dc3U, 0x72be5d74U, 0x80deb1feU,
    0x9bdc06a7U, 0xc19bf174U, 0xe49b69c1U, 0xefbe4786U, 0x0fc19dc6U, 0x240ca1ccU, 0x2de92c6fU,
    0x4a7484aaU, 0x5cb0a9dcU, 0x76f988daU, 0x983e5152U, 0xa831c66dU, 0xb00327c8U, 0xbf597fc7U,
    0xc6e00bf3U, 0xd5a79147U, 0x06ca6351U, 0x14292967U, 0x27b70a85U, 0x2e1b2138U, 0x4d2c6dfcU,
    0x53380d13U, 0x650a7354U, 0x766a0abbU, 0x81c2c92eU, 0x92722c85U, 0xa2bfe8a1U, 0xa81a664bU,
    0xc24b8b70U, 0xc76c51a3U, 0xd192e819U, 0xd6990624U, 0xf40e3585U, 0x106aa070U, 0x19a4c116U,
    0x1e376c08U, 0x2748774cU, 0x34b0bcb5U, 0x391c0cb3U, 0x4ed8aa4aU, 0x5b9cca4fU, 0x682e6ff3U,
    0x748f82eeU, 0x78a5636fU, 0x84c87814U, 0x8cc70208U, 0x90befffaU, 0xa4506cebU, 0xbef9a3f7U,
    0xc67178f2U};

}  // namespace

void Sha256::take_block(const std::byte* block) noexcept {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 16; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            w[i] = w[i] << 8 | std::to_integer<std::uint32_t>(block[4 * i + k]);
        }
    }
    for (std::size_t i = 16; i < w.size(); ++i) {
        const std::uint32_t a = w[i - 15];
        const std::uint32_t b = w[i - 2];
        w[i] = w[i - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ a >> 3) + w[i - 7] +
               (std::rotr(b, 17) ^ std::rotr(b, 19) ^ b >> 10);
    }
    auto [a, b, c, d, e, f, g, h] = state_;
    for (std::size_t i = 0; i < w.size(); ++i) {
        const std::uint32_t upper = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                                    ((e & f) ^ (~e & g)) + kRounds[i] + w[i];
        const std::uint32_t lower =
            (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
        h = g;
        g = f;
        f = e;
        e = d + upper;
        d = c;
        c = b;
        b = a;
        a = upper + lower;
    }
    const std::array<std::uint32_t, 8> added{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < state_.size(); ++i) {
        state_[i] += added[i];
    }
}

void Sha256::add(std::span<const std::byte> bytes) noexcept {
    std::size_t n_pending = n_bytes_ % kBlockBytes;
    n_bytes_ += bytes.size();
    while (!bytes.empty()) {
        if (n_pending == 0 && bytes.size() >= kBlockBytes) {
            take_block(bytes.data());
            bytes = bytes.subspan(kBlockBytes);
            continue;
        }
        const std::size_t n = std::min(bytes.size(), kBlockBytes - n_pending);
        std::copy_n(bytes.begin(), n, pending_.begin() + static_cast<std::ptrdiff_t>(n_pending));
        bytes = bytes.subspan(n);
        n_pending += n;
        if (n_pending == kBlockBytes) {
            take_block(pending_.data());
            n_pending = 0;
        }
    }
}

Digest Sha256::finish() noexcept {
    // A one, zeros, and the number of bits as the last eight bytes of a block.
    const std::uint64_t n_bits = 8 * n_bytes_;
    std::array<std::byte, 2 * kBlockBytes> end{std::byte{0x80}};
    constexpr std::size_t kLengthAt = kBlockBytes - 8;
    const std::size_t n_pending = n_bytes_ % kBlockBytes;
    const std::size_t n_zeros_end =
        (n_pending < kLengthAt ? kBlockBytes : 2 * kBlockBytes) - n_pending;
    for (std::size_t i = 0; i < 8; ++i) {
        end[n_zeros_end - 1 - i] = static_cast<std::byte>(n_bits >> (8 * i) & 0xFFU);
    }
    add(std::span(end).first(n_zeros_end));
    Digest digest{};
    for (std::size_t i = 0; i < digest.size(); ++i) {
        digest[i] = static_cast<std::byte>(state_[i / 4] >> (8 * (3 - i % 4)) & 0xFFU);
    }
    return digest;
}

std::string to_hex(const Digest& digest) {
    constexpr const char* kFigures = "0123456789abcdef";
    std::string hex;
    for (const std::byte byte : digest) {
        hex += kFigures[std::to_integer<unsigned>(byte) >> 4U];
        hex += kFigures[std::to_integer<unsigned>(byte) & 15U];
    }
    return hex;
}

}  // namespace fulcrum
