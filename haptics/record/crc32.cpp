#include "haptics/record/record.h"

#include <array>

namespace fulcrum {
namespace {

constexpr std::array<std::uint32_t, 256> make_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < table.size(); ++i) {
        std::uint32_t rest = i;
        for (int bit = 0; bit < 8; ++bit) {
            rest = (rest >> 1) ^ ((rest & 1U) != 0 ? 0xEDB88320U : 0U);
        }
        table[i] = rest;
    }
    return table;
}

constexpr std::array<std::uint32_t, 256> kTable = make_table();

}  // namespace

std::uint32_t compute_crc32(std::span<const std::byte> bytes, std::uint32_t before) noexcept {
    std::uint32_t rest = ~before;
    for (const std::byte byte : bytes) {
        rest = kTable[(rest ^ static_cast<std::uint32_t>(byte)) & 0xFFU] ^ (rest >> 8);
    }
    return ~rest;
}

}  // namespace fulcrum
