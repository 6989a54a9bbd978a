#include "runtime/files/line_program.h"

#include "haptics/base/clock.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace fulcrum::runtime {

std::vector<std::string> shell_line(const std::string& line) {
    return {"/bin/sh", "-c", line};
}

Expected<std::unique_ptr<LineProgram>> LineProgram::start(const std::vector<std::string>& words,
                                                          const std::vector<std::string>& kept) {
    if (words.empty() || words.front().empty()) {
        return fail("no program is named", {}, "name one");
    }
    // Whoever wrote a line for the shell knows it by that.
    std::unique_ptr<LineProgram> made(
        new LineProgram(words == shell_line(words.back()) ? words.back() : words.front()));
    std::array<int, 2> ends{};
    int error = socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0 ? 0 : errno;
    if (error == 0) {
        made->socket_ = ends[0];
        fcntl(made->socket_, F_SETFL, O_NONBLOCK);
        error = made->program_.start(words, ends[1], ends[1], kept);
        close(ends[1]);
    }
    if (error != 0) {
        return fail(
            "the program " + words.front() + " can't be started (" + std::strerror(error) + ")", {},
            "install it anew, or choose another");
    }
    return made;
}

LineProgram::~LineProgram() {
    if (socket_ >= 0) {
        close(socket_);
    }
}

void LineProgram::send(std::string_view line) {
    if (!trouble_.empty()) {
        return;
    }
    to_write_ += line;
    to_write_ += '\n';
    if (to_write_.size() > kMostQueued_bytes) {
        end("takes nothing");
        return;
    }
    write_some();
}

std::optional<std::string> LineProgram::take() {
    if (trouble_.empty()) {
        write_some();
    }
    if (auto line = whole_line()) {
        return line;
    }
    if (trouble_.empty()) {
        read_some();
    }
    return whole_line();
}

std::optional<std::string> LineProgram::whole_line() {
    const std::size_t line_end = read_.find('\n');
    if (line_end == std::string::npos) {
        return {};
    }
    std::string line = read_.substr(0, line_end);
    read_.erase(0, line_end + 1);
    return line;
}

std::optional<std::string> LineProgram::wait(double patience_s) {
    const double end_s = monotonic_now_s() + patience_s;
    auto line = take();
    for (double left_s = patience_s; !line && trouble_.empty() && left_s > 0.0;
         left_s = end_s - monotonic_now_s()) {
        const auto events = static_cast<short>(to_write_.empty() ? POLLIN : POLLIN | POLLOUT);
        pollfd file{socket_, events, 0};
        (void)poll(&file, 1, static_cast<int>(std::ceil(1.0e3 * left_s)));
        line = take();
    }
    return line;
}

void LineProgram::write_some() {
    while (!to_write_.empty()) {
        const ssize_t n = ::send(socket_, to_write_.data(), to_write_.size(), MSG_NOSIGNAL);
        if (n < 0) {
            if (errno != EAGAIN && errno != EINTR && errno != EPIPE && errno != ECONNRESET) {
                end("cannot be spoken to");
            }
            return;  // who has ended is noticed by reading
        }
        to_write_.erase(0, static_cast<std::size_t>(n));
    }
}

// Up to the end of a line, and no longer than one can be.
void LineProgram::read_some() {
    std::array<char, 16384> part{};
    for (bool goes_on = true; goes_on;) {
        const ssize_t n = recv(socket_, part.data(), part.size(), 0);
        if (n < 0 && errno != ECONNRESET) {
            return;
        }
        if (n <= 0) {
            end("has ended");
            return;
        }
        const std::size_t before = read_.size();
        read_.append(part.data(), static_cast<std::size_t>(n));
        const std::size_t line_end = read_.find('\n', before);
        if (std::min(line_end, read_.size()) > kLongestLine_bytes) {
            end("says a line that is too long");
            return;
        }
        goes_on = line_end == std::string::npos;
    }
}

void LineProgram::finish(double patience_s) {
    if (trouble_.empty()) {
        write_some();
        (void)shutdown(socket_, SHUT_WR);
        (void)program_.ends_well(monotonic_now_s() + patience_s);
        end("was ended");
    }
}

void LineProgram::end(const std::string& why) {
    if (!trouble_.empty()) {
        return;
    }
    trouble_ = "the program " + name_ + " " + why;
    to_write_.clear();
    read_.clear();
    close(socket_);
    socket_ = -1;
    program_.end();
}

}  // namespace fulcrum::runtime
