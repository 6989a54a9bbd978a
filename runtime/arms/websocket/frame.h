// Frames of a WebSocket at the client's side, without a socket: what is sent is masked, what comes is put together.
//
//   0  FIN, RSV1-3, opcode · 1  MASK, length of 7 bits (126: 16 bits follow, 127: 64) · mask, 4 bytes · payload
// A message may come in several frames, with control frames between them. What a server may not send (masked, RSV bits, binary, an
// unknown opcode, a control frame that is long or in parts, more than kMostMessageBytes) ends it: `next` says broken from there on.
//
// Thread: its owner's. Cost: a copy a byte; the reader's buffer grows to the largest message.
// Source: RFC 6455, sections 5.2 (layout), 5.3 (masking), 5.4 (fragments), 5.5 (control frames).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

enum class Opcode : std::uint8_t {
    continuation = 0x0,
    text = 0x1,
    binary = 0x2,
    close = 0x8,
    ping = 0x9,
    pong = 0xa,
};

/// A state of an arm has about a thousand bytes.
inline constexpr std::size_t kMostMessageBytes = 1U << 20U;
inline constexpr std::size_t kMostControlBytes = 125;
inline constexpr int kMostParts = 1000;  ///< frames of one message, which may be empty

using FrameMask = std::array<std::uint8_t, 4>;

/// Puts a whole message, masked, behind `out`.
void append_frame(Opcode opcode, std::string_view payload, const FrameMask& mask, std::string& out);

class FrameReader {
  public:
    enum class Got : std::uint8_t { nothing, text, ping, pong, close, broken };

    /// What came from the other side, in any pieces.
    void feed(std::string_view bytes);
    /// The next whole message or control frame; its payload stays until the next call.
    [[nodiscard]] Got next();
    [[nodiscard]] const std::string& payload() const noexcept { return payload_; }
    /// Why it is broken, a clause; empty while it is not.
    [[nodiscard]] std::string_view why() const noexcept { return why_; }

  private:
    struct Head {
        Opcode opcode = Opcode::text;
        bool is_last = false;
        std::size_t at = 0;  // of the payload, from where the frame begins
        std::size_t length = 0;
    };
    [[nodiscard]] bool read_head(Head& head);
    [[nodiscard]] bool is_allowed(std::uint8_t first, std::uint8_t second);
    [[nodiscard]] Got take(const Head& head);
    [[nodiscard]] Got fail(std::string_view why);

    std::string buffer_;     // what came and is not taken
    std::size_t begin_ = 0;  // of it
    std::string parts_;      // of a message that is not whole
    bool has_parts_ = false;
    int n_parts_ = 0;
    std::string payload_;
    std::string_view why_;
};

}  // namespace fulcrum::runtime
