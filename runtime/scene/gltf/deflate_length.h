// How many bytes compressed data would become, without making them: a bomb is recognised for the
// price of reading it.
//
// Source: P. Deutsch, RFC 1950 (zlib) and RFC 1951 (DEFLATE), 1996.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace fulcrum::runtime::gltf {

/// Bytes that a zlib stream expands to; nothing when the stream is malformed or expands to more
/// than `limit_bytes`. Reads at most until the limit is passed. The checksum at the end is not
/// compared.
[[nodiscard]] std::optional<std::size_t> inflated_length(std::span<const std::uint8_t> zlib,
                                                         std::size_t limit_bytes);

}  // namespace fulcrum::runtime::gltf
