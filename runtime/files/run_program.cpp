#include "runtime/files/run_program.h"

#include "haptics/base/clock.h"
#include "runtime/files/start_program.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr int kLook_ms = 20;  // how often it is seen that nobody waits any more

// A program that runs, its answer's end of a pipe in hand.
class Running {
  public:
    Running() = default;
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() {
        if (pipe_ >= 0) {
            close(pipe_);
        }
    }

    // 0, or the system's number for what went wrong.
    int start(const std::vector<std::string>& words) {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) {
            return errno;
        }
        pipe_ = ends[0];
        const int error = program_.start(words, -1, ends[1]);
        close(ends[1]);
        return error;
    }

    // Bytes read, 0 at the end; nothing yet: -1.
    ssize_t read_some(char* to, std::size_t n) const {
        pollfd file{pipe_, POLLIN, 0};
        if (poll(&file, 1, kLook_ms) <= 0) {
            return -1;
        }
        const ssize_t got = read(pipe_, to, n);
        return got < 0 && errno != EINTR ? 0 : got;
    }

    bool ends_well(double end_s) { return program_.ends_well(end_s); }

  private:
    StartedProgram program_;
    int pipe_ = -1;
};

tl::unexpected<Error> refuse(const ProgramOrder& order, const std::string& why) {
    return fail("the program " + order.words.front() + " " + why, {},
                "install it anew, or choose another");
}

}  // namespace

Expected<std::string> run_program(const ProgramOrder& order, const std::atomic<bool>& cancelled) {
    if (order.words.empty() || order.words.front().empty()) {
        return fail("no program is named", {}, "name one");
    }
    Running program;
    if (const int error = program.start(order.words); error != 0) {
        return refuse(order, std::string("can't be started (") + std::strerror(error) + ")");
    }
    const double end_s = monotonic_now_s() + order.most_s;
    std::string written;
    std::array<char, 16384> part{};
    for (;;) {
        const ssize_t n = program.read_some(part.data(), part.size());
        if (n == 0) {
            break;
        }
        if (n > 0) {
            written.append(part.data(), static_cast<std::size_t>(n));
        }
        if (written.size() > order.most_bytes) {
            return refuse(order, "wrote more than " + std::to_string(order.most_bytes) + " bytes");
        }
        if (monotonic_now_s() > end_s) {
            return refuse(order, "took too long");
        }
        if (cancelled.load(std::memory_order_acquire)) {
            return refuse(order, "was stopped");
        }
    }
    return program.ends_well(end_s) ? Expected<std::string>(std::move(written))
                                    : Expected<std::string>(refuse(order, "failed"));
}

}  // namespace fulcrum::runtime
