// The server's side of a WebSocket, written apart from the client's so that neither's mistake hides the other's (RFC 6455).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::test_support {

/// How a message is cut and counted.
struct WireHabits {
    bool in_fragments = false;  ///< three of them, with a ping between the last two
    bool pings = false;         ///< before each message
    bool long_lengths = false;  ///< 64 bits for every length
};

/// The bytes of a text message.
[[nodiscard]] std::string make_wire_text(const std::string& text, const WireHabits& habits);

/// What a client has sent so far, less what was taken; opcodes 1 and 10 (pong) alone say something.
struct ClientMessages {
    std::vector<std::string> texts;
    std::vector<std::string> pongs;
    bool says_goodbye = false;
    bool was_unmasked = false;  ///< which a client's frame must not be
};
[[nodiscard]] ClientMessages take_client_frames(std::string& bytes);

/// The answer to a client that asks for a WebSocket; nothing where it does not.
[[nodiscard]] std::optional<std::string> answer_upgrade(std::string_view head);

}  // namespace fulcrum::test_support
