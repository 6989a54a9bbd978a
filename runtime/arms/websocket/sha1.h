// SHA-1 of a few bytes: what a WebSocket's handshake proves itself with, and nothing that is to be kept secret.
//
// Thread: any. Cost: a microsecond a hundred bytes; allocates nothing.
// Source: FIPS 180-4, sections 5.1.1 and 6.1; RFC 3174.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace fulcrum::runtime {

using Sha1Digest = std::array<std::uint8_t, 20>;

/// The digest of `bytes`, most significant byte first.
[[nodiscard]] Sha1Digest compute_sha1(std::string_view bytes) noexcept;

}  // namespace fulcrum::runtime
