#include "runtime/lua/process/child_process.h"

#include "runtime/files/start_program.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr int kFirstSafeDescriptor = 10;  // above those that the child gets

tl::unexpected<Error> refused(const char* what, int error) {
    return fail(std::string("a process for the lesson can't be started (") + what + ": " +
                    std::strerror(error) + ")",
                {}, "close other programs and try again");
}

/// Closed when it goes.
struct Descriptor {
    int number = -1;
    Descriptor() = default;
    explicit Descriptor(int n) : number(n) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number >= 0) {
            close(number);
        }
    }
    /// Moves out of the way of the child's own numbers.
    void move_up() {
        if (number >= 0 && number < kFirstSafeDescriptor) {
            const int higher = fcntl(number, F_DUPFD_CLOEXEC, kFirstSafeDescriptor);
            close(number);
            number = higher;
        }
    }
};

/// The child gets no environment but what sanitizers and unusual library paths need.
std::vector<char*> child_environment() {
    constexpr std::array kPassed = {
        "LD_LIBRARY_PATH=", "ASAN_OPTIONS=", "UBSAN_OPTIONS=", "TSAN_OPTIONS="};
    std::vector<char*> environment;
    for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
        for (const char* prefix : kPassed) {
            if (std::strncmp(*entry, prefix, std::strlen(prefix)) == 0) {
                environment.push_back(*entry);
            }
        }
    }
    environment.push_back(nullptr);
    return environment;
}

int spawn(pid_t& pid, const std::string& executable, int socket, int page) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_adddup2(&actions, socket, kLessonSocket);
    posix_spawn_file_actions_adddup2(&actions, page, kLessonPage);
    set_apart(attributes);
    std::string name = "fulcrum-lesson";
    std::string argument = kLessonArgument;
    std::string number = std::to_string(kLessonSocket);
    const std::array<char*, 4> arguments = {name.data(), argument.data(), number.data(), nullptr};
    std::vector<char*> environment = child_environment();
    const int error = posix_spawn(&pid, executable.c_str(), &actions, &attributes, arguments.data(),
                                  environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

/// A file in memory of one page, that nobody can make shorter: the program reads what it maps.
int make_page_file() {
    const int file = memfd_create("fulcrum-lesson", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (file >= 0 && (ftruncate(file, kSharedPageBytes) != 0 ||
                      fcntl(file, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0)) {
        close(file);
        return -1;
    }
    return file;
}

}  // namespace

Expected<std::unique_ptr<ChildProcess>> ChildProcess::start(const std::string& executable,
                                                            std::size_t memory_bytes) {
    std::unique_ptr<ChildProcess> child(new ChildProcess());
    Descriptor page(make_page_file());
    if (page.number < 0) {
        return refused("memfd", errno);
    }
    void* mapped =
        mmap(nullptr, kSharedPageBytes, PROT_READ | PROT_WRITE, MAP_SHARED, page.number, 0);
    if (mapped == MAP_FAILED) {
        return refused("mmap", errno);
    }
    child->page_ = new (mapped) SharedPage();
    child->page_->memory_bytes = memory_bytes;
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        return refused("socketpair", errno);
    }
    child->socket_ = ends[0];
    Descriptor theirs(ends[1]);
    fcntl(child->socket_, F_SETFL, O_NONBLOCK);
    theirs.move_up();
    page.move_up();
    if (const int error = spawn(child->pid_, executable, theirs.number, page.number); error != 0) {
        child->pid_ = -1;
        return refused("posix_spawn", error);
    }
    return child;
}

ChildProcess::~ChildProcess() {
    end();
    if (socket_ >= 0) {
        close(socket_);
    }
    if (page_ != nullptr) {
        munmap(page_, kSharedPageBytes);
    }
}

double ChildProcess::cpu_s() const noexcept {
    clockid_t clock{};
    timespec time{};
    if (pid_ < 0 || clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &time) != 0) {
        return 0.0;
    }
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void ChildProcess::wait_for(short events, double timeout_s) const noexcept {
    pollfd file{socket_, events, 0};
    const double whole_s = std::floor(timeout_s);
    const timespec timeout{static_cast<time_t>(whole_s),
                           static_cast<long>((timeout_s - whole_s) * 1e9)};
    ppoll(&file, 1, &timeout, nullptr);
}
void ChildProcess::wait_readable(double timeout_s) const noexcept {
    wait_for(POLLIN, timeout_s);
}
void ChildProcess::wait_writable(double timeout_s) const noexcept {
    wait_for(POLLOUT, timeout_s);
}

ProcessEnd ChildProcess::end() noexcept {
    if (pid_ >= 0) {
        // Until it is waited for nobody else can get its number.
        kill(pid_, SIGKILL);
        int status = 0;
        while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        ended_ = WIFSIGNALED(status) ? ProcessEnd{true, WTERMSIG(status)}
                                     : ProcessEnd{false, WEXITSTATUS(status)};
        pid_ = -1;
    }
    return ended_;
}

ScriptError ChildProcess::last_seen() const {
    ScriptError place;
    const std::int32_t line = page_->running.line.load(std::memory_order_acquire);
    place.line = line > 0 && line < 10'000'000 ? line : 0;
    const auto& file = page_->running.file;
    place.file =
        clean_text(std::string_view(file.data(), strnlen(file.data(), file.size())), file.size());
    return place;
}

}  // namespace fulcrum::runtime
