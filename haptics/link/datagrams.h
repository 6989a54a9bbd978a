// Where packets go out and come in, without order and without promise: a socket, or a channel in memory with faults of its own.
//
// Thread: the loop that owns the link. Neither call waits or allocates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace fulcrum {

/// Who a packet is from, as the channel knows it; opaque to everybody else. Two of one peer compare equal.
struct PeerAddress {
    std::array<std::uint8_t, 28> bytes{};
    std::uint8_t size = 0;  ///< 0 for nobody
    friend bool operator==(const PeerAddress&, const PeerAddress&) = default;
};

class Datagrams {
  public:
    Datagrams() = default;
    Datagrams(const Datagrams&) = delete;
    Datagrams& operator=(const Datagrams&) = delete;
    virtual ~Datagrams() = default;

    /// Sends one packet at `now_s` of the caller's clock, to `to`, or where there is only one peer, to that. False when it
    /// certainly did not go; true promises nothing.
    virtual bool send(double now_s, const PeerAddress& to,
                      std::span<const std::byte> packet) noexcept = 0;
    /// The next packet that has arrived by `now_s`, cut to `packet`; its whole size, which may be more, and whom it is from.
    /// 0 when there is none.
    [[nodiscard]] virtual std::size_t receive(double now_s, std::span<std::byte> packet,
                                              PeerAddress& from) noexcept = 0;
};

}  // namespace fulcrum
