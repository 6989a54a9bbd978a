#include "runtime/lua/wire/channel.h"

#include <cerrno>
#include <cstring>
#include <sys/socket.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kHeadBytes = sizeof(std::uint32_t);
constexpr std::size_t kReadBytes = 64U << 10U;

}  // namespace

Channel::Result Channel::take(RawMessage& message) {
    const std::size_t n = filled_ - taken_;
    if (n < kHeadBytes + 1) {
        return Result::nothing;
    }
    std::uint32_t length = 0;
    std::memcpy(&length, buffer_.data() + taken_, sizeof(length));
    const std::uint8_t kind = buffer_[taken_ + kHeadBytes];
    if (length == 0 || length > max_bytes_ || kind > static_cast<std::uint8_t>(WireKind::error)) {
        return Result::malformed;
    }
    if (n < kHeadBytes + length) {
        return Result::nothing;
    }
    message.kind = static_cast<WireKind>(kind);
    message.body = std::span(buffer_).subspan(taken_ + kHeadBytes + 1, length - 1);
    taken_ += kHeadBytes + length;
    return Result::message;
}

Channel::Result Channel::receive(RawMessage& message) {
    if (const Result result = take(message); result != Result::nothing) {
        return result;
    }
    // What is left of the last read moves to the front.
    if (taken_ > 0) {
        std::memmove(buffer_.data(), buffer_.data() + taken_, filled_ - taken_);
        filled_ -= taken_;
        taken_ = 0;
    }
    if (buffer_.size() < filled_ + kReadBytes) {
        buffer_.resize(filled_ + kReadBytes);
    }
    const ssize_t n = read(socket_, buffer_.data() + filled_, buffer_.size() - filled_);
    if (n == 0) {
        return Result::closed;
    }
    if (n < 0) {
        return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR ? Result::nothing
                                                                         : Result::closed;
    }
    filled_ += static_cast<std::size_t>(n);
    return take(message);
}

std::optional<std::size_t> Channel::send(std::span<const std::uint8_t> bytes) const {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
        const ssize_t n = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
        if (n > 0) {
            sent += static_cast<std::size_t>(n);
        } else if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
            return sent;
        } else if (n < 0 && errno != EINTR) {
            return std::nullopt;
        }
    }
    return sent;
}

}  // namespace fulcrum::runtime
