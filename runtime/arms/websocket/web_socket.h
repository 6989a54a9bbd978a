// A WebSocket's client at this computer: text to and fro, each with its deadline. Pings are answered on the way.
//
// Thread: its owner's. Cost: two system calls a message.
// Source: RFC 6455. No extension, no TLS: the other side is a service at 127.0.0.1.
#pragma once

#include "haptics/base/error.h"
#include "runtime/arms/websocket/frame.h"
#include "runtime/arms/websocket/loopback_socket.h"

#include <memory>

namespace fulcrum::runtime {

class WebSocket {
  public:
    enum class Heard : std::uint8_t { text, nothing, gone };

    /// Refuses where nobody listens at the port, where what answers is no WebSocket, and where that is not settled by the deadline
    /// (seconds of the monotonic clock, as all here).
    [[nodiscard]] static Expected<std::unique_ptr<WebSocket>> connect(std::uint16_t port,
                                                                      double deadline_s);
    WebSocket(const WebSocket&) = delete;
    WebSocket& operator=(const WebSocket&) = delete;
    ~WebSocket() { close(); }

    /// False where it did not go as a whole by the deadline: then the line is of no more use, and closed.
    [[nodiscard]] bool send(std::string_view text, double deadline_s) noexcept;
    /// The next message into `text`, waiting until the deadline; a message that has come is given even where the deadline has passed.
    [[nodiscard]] Heard receive(std::string& text, double deadline_s) noexcept;
    /// Why it is gone, a clause; empty where it is not.
    [[nodiscard]] const std::string& why() const noexcept { return why_; }
    /// Says goodbye and closes; waits for nobody. Again: nothing.
    void close() noexcept;

  private:
    explicit WebSocket(LoopbackSocket line) : line_(std::move(line)) {}
    [[nodiscard]] bool send_frame(Opcode opcode, std::string_view payload,
                                  double deadline_s) noexcept;
    [[nodiscard]] bool answer_ping(double deadline_s) noexcept;
    [[nodiscard]] Heard leave(std::string_view why) noexcept;

    LoopbackSocket line_;
    FrameReader reader_;
    std::string received_;  // reused
    std::string frame_;     // likewise
    std::string why_;
};

}  // namespace fulcrum::runtime
