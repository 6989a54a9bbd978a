// What makes a packet unforgeable: a tag that only who has the key can make.
//
// Thread: one caller at a time. Cost: about a microsecond for a packet, by HMAC-SHA-256.
// Source: RFC 2104, HMAC: keyed-hashing for message authentication. The program's own is runtime/link/sodium_seal.h.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace fulcrum {

inline constexpr std::size_t kSealBytes = 32;
using SealTag = std::array<std::byte, kSealBytes>;

class Seal {
  public:
    Seal() = default;
    Seal(const Seal&) = delete;
    Seal& operator=(const Seal&) = delete;
    virtual ~Seal() = default;

    /// The tag of `message`. Neither allocates nor waits.
    [[nodiscard]] virtual SealTag make(std::span<const std::byte> message) const noexcept = 0;
    /// Whether `tag` is the one of `message`; compared in a time that does not depend on where they differ.
    [[nodiscard]] virtual bool holds(std::span<const std::byte> message,
                                     std::span<const std::byte, kSealBytes> tag) const noexcept = 0;
};

}  // namespace fulcrum
