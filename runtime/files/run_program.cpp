#include "runtime/files/run_program.h"

#include "haptics/base/clock.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr int kLook_ms = 20;  // how often it is seen that nobody waits any more

std::vector<std::string> passed_environment() {
    constexpr std::array kPassed{"PATH=",         "LD_LIBRARY_PATH=", "ESPEAK_DATA_PATH=",
                                 "ASAN_OPTIONS=", "UBSAN_OPTIONS=",   "TSAN_OPTIONS="};
    std::vector<std::string> passed;
    for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
        for (const char* prefix : kPassed) {
            if (std::strncmp(*entry, prefix, std::strlen(prefix)) == 0) {
                passed.emplace_back(*entry);
            }
        }
    }
    return passed;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    pointers.reserve(texts.size() + 1);
    for (std::string& text : texts) {
        pointers.push_back(text.data());
    }
    pointers.push_back(nullptr);
    return pointers;
}

// A group of its own, no signal blocked or ignored, ordinary scheduling whatever thread starts it.
void set_apart(posix_spawnattr_t& attributes) {
    sigset_t none;
    sigset_t all;
    sigemptyset(&none);
    sigfillset(&all);
    const sched_param ordinary{};
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setschedpolicy(&attributes, SCHED_OTHER);
    posix_spawnattr_setschedparam(&attributes, &ordinary);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF |
                                              POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSCHEDULER);
}

// A program that runs, its answer's end of a pipe in hand; killed when this goes.
class Running {
  public:
    Running() = default;
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() {
        if (pid_ >= 0) {
            kill(-pid_, SIGKILL);  // what it started, too
            kill(pid_, SIGKILL);
            while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
            }
        }
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
        std::vector<std::string> arguments = words;
        std::vector<std::string> environment = passed_environment();
        posix_spawn_file_actions_t actions;
        posix_spawnattr_t attributes;
        posix_spawn_file_actions_init(&actions);
        posix_spawnattr_init(&attributes);
        posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
        posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
        set_apart(attributes);
        const int error =
            posix_spawnp(&pid_, words.front().c_str(), &actions, &attributes,
                         pointers_to(arguments).data(), pointers_to(environment).data());
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&actions);
        close(ends[1]);
        if (error != 0) {
            pid_ = -1;
        }
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

    // Whether it ends by itself until then, and well. Who closes his output may still go on.
    bool ends_well(double end_s) {
        int status = 0;
        while (pid_ >= 0) {
            const pid_t ended = waitpid(pid_, &status, WNOHANG);
            if (ended == pid_) {
                pid_ = -1;
                return WIFEXITED(status) && WEXITSTATUS(status) == 0;
            }
            if ((ended < 0 && errno != EINTR) || monotonic_now_s() > end_s) {
                break;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    }

  private:
    int pipe_ = -1;
    pid_t pid_ = -1;
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
