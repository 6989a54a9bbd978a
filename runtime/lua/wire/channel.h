// Messages over a stream socket, whole ones only, on either side.
//
// Thread: one. Cost: one system call for a small message each way.
#pragma once

#include "runtime/lua/wire/wire.h"

#include <optional>
#include <span>

namespace fulcrum::runtime {

/// A message as it came: what kind it says it is, and the bytes after that.
struct RawMessage {
    WireKind kind = WireKind::error;
    std::span<const std::uint8_t> body;  ///< valid until the next receive
};

class Channel {
  public:
    enum class Result : std::uint8_t {
        message,    ///< there is one
        nothing,    ///< not yet
        closed,     ///< the other side is gone
        malformed,  ///< a length or kind that can't be
    };

    /// Reads and writes `socket`, which stays the caller's; messages longer than `max_bytes` are malformed.
    Channel(int socket, std::size_t max_bytes) : socket_(socket), max_bytes_(max_bytes) {}

    /// Takes the next message that has arrived whole; when there is none, asks the socket once (the socket's own mode
    /// decides whether that waits).
    [[nodiscard]] Result receive(RawMessage& message);
    /// Sends everything, as long as the socket takes it; the number of bytes that were sent, or nothing when the other side is gone.
    [[nodiscard]] std::optional<std::size_t> send(std::span<const std::uint8_t> bytes) const;

  private:
    [[nodiscard]] Result take(RawMessage& message);

    int socket_;
    std::size_t max_bytes_;
    Bytes buffer_;
    std::size_t filled_ = 0;  ///< bytes in the buffer
    std::size_t taken_ = 0;   ///< of which the last message ended here
};

}  // namespace fulcrum::runtime
