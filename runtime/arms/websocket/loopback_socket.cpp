#include "runtime/arms/websocket/loopback_socket.h"

#include "haptics/base/clock.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace fulcrum::runtime {

LoopbackSocket& LoopbackSocket::operator=(LoopbackSocket&& other) noexcept {
    if (this != &other) {
        close();
        file_ = std::exchange(other.file_, -1);
    }
    return *this;
}

LoopbackSocket LoopbackSocket::begin(std::uint16_t port) noexcept {
    LoopbackSocket line;
    line.file_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (!line.is_open()) {
        return line;
    }
    const int on = 1;
    (void)::setsockopt(line.file_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(line.file_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 &&
        errno != EINPROGRESS) {
        line.close();
    }
    return line;
}

bool LoopbackSocket::waits_for(short event, double deadline_s) const noexcept {
    for (;;) {
        const double left_s = std::max(0.0, deadline_s - monotonic_now_s());
        const double whole_s = std::floor(left_s);
        const timespec wait{.tv_sec = static_cast<time_t>(whole_s),
                            .tv_nsec = static_cast<long>(1e9 * (left_s - whole_s))};
        pollfd line{file_, event, 0};
        const int ready = ::ppoll(&line, 1, &wait, nullptr);
        if (ready > 0) {
            return true;
        }
        if (ready == 0 || errno != EINTR) {
            return false;
        }
    }
}

bool LoopbackSocket::is_connected(double deadline_s) noexcept {
    if (!is_open() || !waits_for(POLLOUT, deadline_s)) {
        return false;
    }
    int error = 0;
    socklen_t size = sizeof error;
    return ::getsockopt(file_, SOL_SOCKET, SO_ERROR, &error, &size) == 0 && error == 0;
}

std::size_t LoopbackSocket::send(std::string_view bytes, double deadline_s) noexcept {
    std::size_t sent = 0;
    while (is_open() && sent < bytes.size()) {
        const ssize_t n = ::send(file_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
        if (n >= 0) {
            sent += static_cast<std::size_t>(n);
        } else if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) {
            if (!waits_for(POLLOUT, deadline_s)) {
                return sent;
            }
        } else {
            close();
        }
    }
    return sent;
}

LoopbackSocket::Received LoopbackSocket::receive(std::string& to, double deadline_s) noexcept {
    std::array<char, 16384> piece;  // NOLINT(cppcoreguidelines-pro-type-member-init)
    while (is_open()) {
        const ssize_t n = ::recv(file_, piece.data(), piece.size(), 0);
        if (n > 0) {
            to.append(piece.data(), static_cast<std::size_t>(n));
            return Received::some;
        }
        if (n == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) {
            close();
            break;
        }
        if (!waits_for(POLLIN, deadline_s)) {
            return Received::nothing;
        }
    }
    return Received::closed;
}

void LoopbackSocket::close() noexcept {
    if (is_open()) {
        (void)::close(std::exchange(file_, -1));
    }
}

}  // namespace fulcrum::runtime
