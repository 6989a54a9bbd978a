// A door at 127.0.0.1, at a port that the system chooses.
#pragma once

#include <cstdint>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>
#include <utility>

namespace fulcrum::test_support {

/// Somebody who came in. Reads and writes wait two seconds at most.
class LoopbackGuest {
  public:
    explicit LoopbackGuest(int file) : file_(file) {
        const int on = 1;
        const timeval patience{.tv_sec = 2, .tv_usec = 0};
        (void)::setsockopt(file_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        (void)::setsockopt(file_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
        (void)::setsockopt(file_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    }
    LoopbackGuest(const LoopbackGuest&) = delete;
    LoopbackGuest& operator=(const LoopbackGuest&) = delete;
    LoopbackGuest(LoopbackGuest&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
    LoopbackGuest& operator=(LoopbackGuest&& other) noexcept {
        std::swap(file_, other.file_);
        return *this;
    }
    ~LoopbackGuest() { leave(); }

    [[nodiscard]] int file() const { return file_; }
    /// What there is; empty where the other side has left, or has said nothing for two seconds.
    [[nodiscard]] std::string read() const {
        char bytes[65536];
        const ssize_t n = ::recv(file_, bytes, sizeof bytes, 0);
        return n > 0 ? std::string(bytes, static_cast<std::size_t>(n)) : std::string();
    }
    /// All that comes, up to and with `end`.
    [[nodiscard]] std::string read_until(std::string_view end) const {
        std::string all;
        while (all.find(end) == std::string::npos) {
            const std::string more = read();
            if (more.empty()) {
                break;
            }
            all += more;
        }
        return all;
    }
    /// False where it does not go as a whole.
    bool write(std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t n = ::send(file_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
            if (n <= 0) {
                return false;
            }
            bytes.remove_prefix(static_cast<std::size_t>(n));
        }
        return true;
    }
    void leave() {
        if (file_ >= 0) {
            (void)::close(std::exchange(file_, -1));
        }
    }

  private:
    int file_;
};

class LoopbackListener {
  public:
    /// At `port` where somebody stood before; 0: the system's choice.
    explicit LoopbackListener(std::uint16_t port = 0)
        : file_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        const int on = 1;
        (void)::setsockopt(file_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        auto* const general = reinterpret_cast<sockaddr*>(&address);
        socklen_t size = sizeof address;
        constexpr int kMostWaiting = 16;
        if (file_ < 0 || ::bind(file_, general, sizeof address) != 0 ||
            ::listen(file_, kMostWaiting) != 0 || ::getsockname(file_, general, &size) != 0) {
            throw std::runtime_error("no port at this computer");
        }
        port_ = ntohs(address.sin_port);
    }
    LoopbackListener(const LoopbackListener&) = delete;
    LoopbackListener& operator=(const LoopbackListener&) = delete;
    ~LoopbackListener() { (void)::close(file_); }

    [[nodiscard]] std::uint16_t port() const { return port_; }
    [[nodiscard]] int file() const { return file_; }
    /// Who comes next.
    [[nodiscard]] LoopbackGuest accept() const {
        return LoopbackGuest(::accept4(file_, nullptr, nullptr, SOCK_CLOEXEC));
    }

  private:
    int file_;
    std::uint16_t port_ = 0;
};

}  // namespace fulcrum::test_support
