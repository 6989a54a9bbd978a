#include "runtime/link/udp_socket.h"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

constexpr const char* kHostPortHelp = "write HOST:PORT, such as localhost:4701";

static_assert(sizeof(sockaddr_in6) <= sizeof(PeerAddress::bytes));

struct AddressList {
    addrinfo* first = nullptr;
    ~AddressList() {
        if (first != nullptr) {
            ::freeaddrinfo(first);
        }
    }
};

}  // namespace

Expected<HostPort> parse_host_port(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || colon == 0) {
        return fail("\"" + text + "\" names no computer and port", "", kHostPortHelp);
    }
    HostPort parsed;
    parsed.host = text.substr(0, colon);
    if (parsed.host.front() == '[' && parsed.host.back() == ']') {
        parsed.host = parsed.host.substr(1, parsed.host.size() - 2);
    } else if (parsed.host.find(':') != std::string::npos) {
        return fail("\"" + text + "\" has more than one colon", "",
                    "write an IPv6 address in brackets, [::1]:4701");
    }
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data() + colon + 1, end, parsed.port);
    if (result.ec != std::errc{} || result.ptr != end || parsed.port == 0 || parsed.host.empty()) {
        return fail("\"" + text + "\" names no computer and port", "", kHostPortHelp);
    }
    return parsed;
}

Expected<std::unique_ptr<UdpSocket>> UdpSocket::open(const HostPort& address, bool connects) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_DGRAM;
    hints.ai_flags = AI_NUMERICSERV | (connects ? 0 : AI_PASSIVE);
    AddressList list;
    const int error = ::getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(),
                                    &hints, &list.first);
    const std::string shown = address.host + ":" + std::to_string(address.port);
    if (error != 0) {
        return fail(std::string("this computer is not known: ") + ::gai_strerror(error), shown,
                    "check its name, or give its number");
    }
    int last_error = 0;
    for (const addrinfo* at = list.first; at != nullptr; at = at->ai_next) {
        const int descriptor =
            ::socket(at->ai_family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        const auto join = connects ? ::connect : ::bind;
        if (descriptor >= 0 && join(descriptor, at->ai_addr, at->ai_addrlen) == 0) {
            return std::unique_ptr<UdpSocket>(new UdpSocket(descriptor, connects));
        }
        last_error = errno;
        if (descriptor >= 0) {
            ::close(descriptor);
        }
    }
    return fail(
        std::string(connects ? "there is no way to it: " : "nothing can be received there: ") +
            std::strerror(last_error),
        shown,
        connects ? "check the network" : "another program may use this port: give --port another");
}

Expected<std::unique_ptr<UdpSocket>> UdpSocket::connect(const HostPort& peer) {
    return open(peer, true);
}

Expected<std::unique_ptr<UdpSocket>> UdpSocket::listen(const HostPort& local) {
    return open(local, false);
}

UdpSocket::~UdpSocket() {
    ::close(descriptor_);
}

bool UdpSocket::send(double /*now_s*/, const PeerAddress& to,
                     std::span<const std::byte> packet) noexcept {
    const bool is_addressed = !is_connected_ && to.size > 0;
    if (!is_connected_ && !is_addressed) {
        return false;
    }
    sockaddr_storage address{};
    std::memcpy(&address, to.bytes.data(), to.size);
    const ssize_t sent =
        ::sendto(descriptor_, packet.data(), packet.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
                 is_addressed ? reinterpret_cast<const sockaddr*>(&address) : nullptr,
                 is_addressed ? to.size : 0);
    was_refused_ = was_refused_ || (sent < 0 && errno == ECONNREFUSED);
    return sent == static_cast<ssize_t>(packet.size());
}

std::size_t UdpSocket::receive(double /*now_s*/, std::span<std::byte> packet,
                               PeerAddress& from) noexcept {
    // A peer that is not there makes an error of the next call; behind it there may be packets.
    constexpr int kMostErrors = 8;
    for (int i = 0; i < kMostErrors; ++i) {
        sockaddr_storage address{};
        socklen_t size = sizeof address;
        const ssize_t got =
            ::recvfrom(descriptor_, packet.data(), packet.size(), MSG_DONTWAIT | MSG_TRUNC,
                       reinterpret_cast<sockaddr*>(&address), &size);
        if (got == 0) {
            return packet.size() + 1;  // an empty packet is one that nobody takes
        }
        if (got > 0 && size <= sizeof from.bytes) {
            from = PeerAddress{};
            std::memcpy(from.bytes.data(), &address, size);
            from.size = static_cast<std::uint8_t>(size);
            return static_cast<std::size_t>(got);
        }
        if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
            return 0;
        }
        was_refused_ = was_refused_ || (got < 0 && errno == ECONNREFUSED);
    }
    return 0;
}

std::uint16_t UdpSocket::port() const noexcept {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    char service[NI_MAXSERV] = {};
    std::uint16_t port = 0;
    if (::getsockname(descriptor_, reinterpret_cast<sockaddr*>(&address), &size) == 0 &&
        ::getnameinfo(reinterpret_cast<sockaddr*>(&address), size, nullptr, 0, service,
                      sizeof service, NI_NUMERICSERV | NI_DGRAM) == 0) {
        std::from_chars(service, service + std::strlen(service), port);
    }
    return port;
}

}  // namespace fulcrum::runtime
