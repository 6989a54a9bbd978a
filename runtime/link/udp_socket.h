// Packets over the network: one UDP socket, never waited for.
//
// Thread: made by one thread, used by one. Cost: a system call each, a few microseconds.
// Source: RFC 768, user datagram protocol; udp(7).
#pragma once

#include "haptics/base/error.h"
#include "haptics/link/datagrams.h"

#include <cstdint>
#include <memory>
#include <string>

namespace fulcrum::runtime {

/// HOST:PORT, with [..] about an IPv6 address.
struct HostPort {
    std::string host;
    std::uint16_t port = 0;
};
/// Refuses what is no HOST:PORT.
[[nodiscard]] Expected<HostPort> parse_host_port(const std::string& text);

class UdpSocket final : public Datagrams {
  public:
    /// Speaks with one peer alone. Refuses a host that is not known; that nobody answers shows later.
    [[nodiscard]] static Expected<std::unique_ptr<UdpSocket>> connect(const HostPort& peer);
    /// Waits for anybody at `local`; port 0 for any free one. Refuses one that is taken.
    [[nodiscard]] static Expected<std::unique_ptr<UdpSocket>> listen(const HostPort& local);
    ~UdpSocket() override;

    bool send(double now_s, const PeerAddress& to,
              std::span<const std::byte> packet) noexcept override;
    [[nodiscard]] std::size_t receive(double now_s, std::span<std::byte> packet,
                                      PeerAddress& from) noexcept override;

    /// Whether the peer's computer has said that nothing waits at that port (ECONNREFUSED), in any call so far.
    [[nodiscard]] bool was_refused() const noexcept { return was_refused_; }

    /// The port at this end.
    [[nodiscard]] std::uint16_t port() const noexcept;

  private:
    UdpSocket(int descriptor, bool is_connected) noexcept
        : descriptor_(descriptor), is_connected_(is_connected) {}
    [[nodiscard]] static Expected<std::unique_ptr<UdpSocket>> open(const HostPort& address,
                                                                   bool connects);
    int descriptor_;
    bool is_connected_;
    bool was_refused_ = false;
};

}  // namespace fulcrum::runtime
