// By tables eight bytes at a time: with T_k[b] the rest of byte b followed by k zero bytes, the rest of eight bytes is the exclusive or
// of T_7 of the first (with the rest before), T_6 of the second, ... T_0 of the last.
// Source: M. E. Kounavis, F. L. Berry 2005, A systematic approach to building high performance software-based CRC generators, IEEE
// Symp. Computers and Communications (slicing by eight).
//
// By products sixteen bytes at a time: the sixteen bytes h, l before sixteen others d have the rest of h x^192 + l x^128 + d, of which
// the powers may be taken modulo the polynomial beforehand; so h (x^192 mod P) + l (x^128 mod P) + d, sixteen bytes again, stands for all so
// far. Bits stand the other way round: the first is the highest power, and a product of two such numbers comes out a bit too low, so
// that the powers are one less and one bit higher.
// Source: V. Gopal et al. 2009, Fast CRC computation for generic polynomials using PCLMULQDQ instruction, Intel, sections on folding and on
// bit-reflected data. What is left in the end goes through the tables.
#include "haptics/base/crc32.h"

#include "haptics/base/little_endian.h"

#include <array>
#include <cstring>

#if defined(__GNUC__) && defined(__x86_64__)
#include <immintrin.h>
#define FULCRUM_CRC32_BY_PRODUCTS 1
#endif

namespace fulcrum {
namespace {

constexpr std::uint32_t kPolynomial = 0xEDB88320U;
constexpr std::size_t kSlices = 8;
using CrcTables = std::array<std::array<std::uint32_t, 256>, kSlices>;

// The rest times x.
constexpr std::uint32_t multiply_by_x(std::uint32_t rest) {
    return (rest >> 1) ^ ((rest & 1U) != 0 ? kPolynomial : 0U);
}

constexpr CrcTables make_tables() {
    CrcTables tables{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t rest = i;
        for (int bit = 0; bit < 8; ++bit) {
            rest = multiply_by_x(rest);
        }
        tables[0][i] = rest;
    }
    for (std::size_t k = 1; k < kSlices; ++k) {
        for (std::size_t i = 0; i < 256; ++i) {
            const std::uint32_t rest = tables[k - 1][i];
            tables[k][i] = tables[0][rest & 0xFFU] ^ (rest >> 8);
        }
    }
    return tables;
}

constexpr CrcTables kTables = make_tables();

// The rest of `bytes` behind a rest.
std::uint32_t take_by_tables(std::uint32_t rest, std::span<const std::byte> bytes) noexcept {
    const auto of = [](std::size_t slice, std::uint64_t word, int byte) {
        return kTables[slice][(word >> (8 * byte)) & 0xFFU];
    };
    for (; bytes.size() >= kSlices; bytes = bytes.subspan(kSlices)) {
        const std::uint64_t word = rest ^ get_little_endian<std::uint64_t>(bytes.data());
        rest = of(7, word, 0) ^ of(6, word, 1) ^ of(5, word, 2) ^ of(4, word, 3) ^ of(3, word, 4) ^
               of(2, word, 5) ^ of(1, word, 6) ^ of(0, word, 7);
    }
    for (const std::byte byte : bytes) {
        rest = kTables[0][(rest ^ static_cast<std::uint32_t>(byte)) & 0xFFU] ^ (rest >> 8);
    }
    return rest;
}

#ifdef FULCRUM_CRC32_BY_PRODUCTS

constexpr std::size_t kFolded = 16;       // bytes
constexpr std::size_t kLeastFolded = 48;  // below that the tables are as fast

// x^n modulo the polynomial, a bit higher.
constexpr std::uint64_t make_power(int n) {
    std::uint32_t rest = 0x80000000U;
    for (int i = 0; i < n; ++i) {
        rest = multiply_by_x(rest);
    }
    return std::uint64_t{rest} << 1U;
}

// Of 64 bits the first 32 are the higher ones of the product with a power, which has 32.
constexpr auto kFoldsHigh = static_cast<long long>(make_power(128 + 32));
constexpr auto kFoldsLow = static_cast<long long>(make_power(128 - 32));

[[gnu::target("pclmul")]] std::uint32_t take_by_products(
    std::uint32_t rest, std::span<const std::byte> bytes) noexcept {
    const auto load = [&bytes] {
        __m128i next;
        std::memcpy(&next, bytes.data(), sizeof next);
        bytes = bytes.subspan(kFolded);
        return next;
    };
    const __m128i powers = _mm_set_epi64x(kFoldsLow, kFoldsHigh);
    __m128i sum = _mm_xor_si128(load(), _mm_cvtsi32_si128(static_cast<int>(rest)));
    while (bytes.size() >= kFolded) {
        const __m128i high = _mm_clmulepi64_si128(sum, powers, 0x00);
        const __m128i low = _mm_clmulepi64_si128(sum, powers, 0x11);
        sum = _mm_xor_si128(load(), _mm_xor_si128(high, low));
    }
    std::array<std::byte, kFolded> left{};
    std::memcpy(left.data(), &sum, sizeof sum);
    return take_by_tables(take_by_tables(0, left), bytes);
}

bool has_products() noexcept {
    return __builtin_cpu_supports("pclmul") != 0;  // reads what was found before main
}

#endif

}  // namespace

std::uint32_t compute_crc32_by_tables(std::span<const std::byte> bytes,
                                      std::uint32_t before) noexcept {
    return ~take_by_tables(~before, bytes);
}

std::uint32_t compute_crc32(std::span<const std::byte> bytes, std::uint32_t before) noexcept {
#ifdef FULCRUM_CRC32_BY_PRODUCTS
    if (bytes.size() >= kLeastFolded && has_products()) {
        return ~take_by_products(~before, bytes);
    }
#endif
    return compute_crc32_by_tables(bytes, before);
}

}  // namespace fulcrum
