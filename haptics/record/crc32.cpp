// Eight bytes at a time: with T_k[b] the rest of byte b followed by k zero bytes, the rest of eight bytes is the exclusive or of
// T_7 of the first (with the rest before), T_6 of the second, ... T_0 of the last.
// Source: M. E. Kounavis, F. L. Berry 2005, A systematic approach to building high performance software-based CRC generators, IEEE
// Symp. Computers and Communications (slicing by eight).
#include "haptics/record/record.h"

#include <array>

namespace fulcrum {
namespace {

constexpr std::size_t kSlices = 8;
using CrcTables = std::array<std::array<std::uint32_t, 256>, kSlices>;

constexpr CrcTables make_tables() {
    CrcTables tables{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t rest = i;
        for (int bit = 0; bit < 8; ++bit) {
            rest = (rest >> 1) ^ ((rest & 1U) != 0 ? 0xEDB88320U : 0U);
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

std::uint32_t byte_at(std::span<const std::byte> bytes, std::size_t i) noexcept {
    return static_cast<std::uint32_t>(bytes[i]);
}

}  // namespace

std::uint32_t compute_crc32(std::span<const std::byte> bytes, std::uint32_t before) noexcept {
    std::uint32_t rest = ~before;
    std::size_t at = 0;
    for (; at + kSlices <= bytes.size(); at += kSlices) {
        std::uint32_t next = 0;
        for (std::size_t i = 0; i < kSlices; ++i) {
            const std::uint32_t folded = i < 4 ? (rest >> (8 * i)) & 0xFFU : 0U;
            next ^= kTables[kSlices - 1 - i][byte_at(bytes, at + i) ^ folded];
        }
        rest = next;
    }
    for (; at < bytes.size(); ++at) {
        rest = kTables[0][(rest ^ byte_at(bytes, at)) & 0xFFU] ^ (rest >> 8);
    }
    return ~rest;
}

}  // namespace fulcrum
