// The beginning of a WebSocket, without a socket: what the client asks, and whether the answer is one to that question.
//
//   accept = base64(SHA-1(key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11")),   key = base64(16 random bytes)
//
// Thread: any. Cost: microseconds.
// Source: RFC 6455, sections 1.3 and 4.1; RFC 4648, section 4 (base64).
#pragma once

#include "haptics/base/error.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

using HandshakeNonce = std::array<std::uint8_t, 16>;

[[nodiscard]] std::string to_base64(std::span<const std::uint8_t> bytes);

/// What a server that has understood the key answers.
[[nodiscard]] std::string find_accept(std::string_view key);

/// The question for ws://127.0.0.1:port/ with that key.
[[nodiscard]] std::string make_upgrade(std::string_view key, std::uint16_t port);

/// Refuses an answer, given up to its empty line, that is no WebSocket's, or not to the question with `key`.
[[nodiscard]] Expected<void> check_upgrade(std::string_view answer_head, std::string_view key);

}  // namespace fulcrum::runtime
