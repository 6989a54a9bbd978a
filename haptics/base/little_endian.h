// Whole numbers as bytes, the least significant first, on every machine.
//
// Thread: any. Cost: one load or store where memory has that order itself.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstring>

namespace fulcrum {

/// Writes sizeof(T) bytes to `to`, which need not be aligned.
template <std::unsigned_integral T>
void put_little_endian(T value, std::byte* to) noexcept {
    if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(to, &value, sizeof value);
    } else {
        for (std::size_t i = 0; i < sizeof value; ++i) {
            to[i] = static_cast<std::byte>((value >> (8 * i)) & 0xFFU);
        }
    }
}

/// The number in the sizeof(T) bytes from `from` on, which need not be aligned.
template <std::unsigned_integral T>
[[nodiscard]] T get_little_endian(const std::byte* from) noexcept {
    T value{};
    if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(&value, from, sizeof value);
    } else {
        for (std::size_t i = 0; i < sizeof value; ++i) {
            value = static_cast<T>(value | static_cast<T>(static_cast<T>(from[i]) << (8 * i)));
        }
    }
    return value;
}

}  // namespace fulcrum
