// A line to a service at this computer: TCP to 127.0.0.1 and to nowhere else. Nothing waits beyond its deadline.
//
// Thread: its owner's. Cost: a system call or two.
// Source: Linux tcp(7), ppoll(2). Nagle's delay is off: what is sent is one message and waits for an answer.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace fulcrum::runtime {

/// Deadlines are seconds of the monotonic clock; one that has passed does not wait.
class LoopbackSocket {
  public:
    enum class Received : std::uint8_t { some, nothing, closed };

    LoopbackSocket() = default;
    LoopbackSocket(const LoopbackSocket&) = delete;
    LoopbackSocket& operator=(const LoopbackSocket&) = delete;
    LoopbackSocket(LoopbackSocket&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
    LoopbackSocket& operator=(LoopbackSocket&& other) noexcept;
    ~LoopbackSocket() { close(); }

    /// Begins to connect, and waits for nobody: a closed one where it cannot even begin.
    [[nodiscard]] static LoopbackSocket begin(std::uint16_t port) noexcept;
    /// Whether somebody has taken the line by the deadline.
    [[nodiscard]] bool is_connected(double deadline_s) noexcept;

    /// As much of `bytes` as goes by the deadline; tells how much. Less where nobody takes it, or the line is closed.
    [[nodiscard]] std::size_t send(std::string_view bytes, double deadline_s) noexcept;
    /// What has come, behind `to`; waits for something until the deadline.
    [[nodiscard]] Received receive(std::string& to, double deadline_s) noexcept;
    void close() noexcept;
    [[nodiscard]] bool is_open() const noexcept { return file_ >= 0; }

  private:
    [[nodiscard]] bool waits_for(short event, double deadline_s) const noexcept;

    int file_ = -1;
};

}  // namespace fulcrum::runtime
