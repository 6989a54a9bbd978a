// What a picture's file is by its first bytes (PNG, third edition, 5.2; JPEG, T.81, B.1.1.3).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace fulcrum::runtime::picture {

enum class Kind : std::uint8_t { png, jpeg, neither };

[[nodiscard]] inline Kind kind_of(std::span<const std::uint8_t> file) noexcept {
    constexpr std::array<std::uint8_t, 8> kPng{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    constexpr std::array<std::uint8_t, 2> kJpeg{0xFF, 0xD8};
    const auto begins_with = [file](std::span<const std::uint8_t> signature) {
        return file.size() >= signature.size() &&
               std::equal(signature.begin(), signature.end(), file.begin());
    };
    return begins_with(kPng) ? Kind::png : begins_with(kJpeg) ? Kind::jpeg : Kind::neither;
}

}  // namespace fulcrum::runtime::picture
