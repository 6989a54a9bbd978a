#include "runtime/lua/sandbox/sandbox.h"

#include "tests/support/sanitized.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <functional>
#include <netinet/in.h>
#include <signal.h>
#include <string>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

constexpr int kAllowed = 42;  // exit code of a child that got through

/// Runs `attempt` in a child behind the walls, which go up after `before`; its wait status.
int run_in_sandbox(
    const std::function<void(int socket)>& attempt, const std::function<void()>& before = [] {}) {
    std::array<int, 2> ends{};
    REQUIRE(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) == 0);
    const int canary = open("/dev/null", O_RDWR);
    const pid_t pid = fork();
    REQUIRE(pid >= 0);
    if (pid == 0) {
        before();
        const bool ready =
            close_all_files_but(ends[1], ends[1] + 1) && enter_sandbox({ends[1], 16U << 20U});
        if (!ready) {
            _exit(1);
        }
        attempt(ends[1]);
        _exit(kAllowed);
    }
    close(ends[1]);
    close(canary);
    int status = 0;
    REQUIRE(waitpid(pid, &status, 0) == pid);
    close(ends[0]);
    return status;
}

bool was_killed(const std::function<void(int)>& attempt) {
    const int status = run_in_sandbox(attempt);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGSYS;
}

bool was_let(const std::function<void(int)>& attempt) {
    const int status = run_in_sandbox(attempt);
    return WIFEXITED(status) && WEXITSTATUS(status) == kAllowed;
}

TEST_CASE("sandbox: files, processes, network and the like kill the process") {
    CHECK(was_killed([](int) { syscall(SYS_openat, AT_FDCWD, "/etc/passwd", O_RDONLY); }));
    CHECK(was_killed([](int) { syscall(SYS_socket, AF_INET, SOCK_STREAM, 0); }));
    CHECK(was_killed([](int) { syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0); }));
    CHECK(was_killed([](int) { syscall(SYS_execve, "/bin/true", nullptr, nullptr); }));
    CHECK(was_killed([](int) { syscall(SYS_kill, getppid(), SIGTERM); }));
    CHECK(was_killed([](int) { syscall(SYS_ptrace, 0, 0, 0, 0); }));
    CHECK(was_killed([](int) { syscall(SYS_unlinkat, AT_FDCWD, "/nonexistent", 0); }));
    CHECK(was_killed([](int) { syscall(SYS_prctl, PR_SET_DUMPABLE, 1, 0, 0, 0); }));
    CHECK(was_killed([](int) { syscall(SYS_seccomp, 0, 0, nullptr); }));
    CHECK(was_killed([](int) { syscall(SYS_getrandom, nullptr, 0, 0); }));
    CHECK(was_killed([](int) { syscall(SYS_io_uring_setup, 1, nullptr); }));
    CHECK(was_killed([](int socket) { syscall(SYS_ftruncate, socket, 0); }));
    CHECK(was_killed(
        [](int socket) { syscall(SYS_recvmsg, socket, nullptr, 0); }));  // could take in a file
    CHECK(was_killed([](int socket) { syscall(SYS_sendmsg, socket, nullptr, 0); }));
}

TEST_CASE("sandbox: other files than the socket, and memory that can be run, kill the process") {
    CHECK(was_killed([](int) {
        char byte = 0;
        syscall(SYS_read, STDIN_FILENO, &byte, 1);
    }));
    CHECK(was_killed([](int) { syscall(SYS_sendto, STDOUT_FILENO, "x", 1, 0, nullptr, 0); }));
    CHECK(was_killed([](int) {
        syscall(SYS_mmap, nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    }));
    CHECK(was_killed(
        [](int) { syscall(SYS_mmap, nullptr, 4096, PROT_READ, MAP_PRIVATE, STDIN_FILENO, 0); }));
    CHECK(was_killed([](int) {
        void* page =
            mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        syscall(SYS_mprotect, page, 4096, PROT_READ | PROT_EXEC);
    }));
}

#if defined(__x86_64__)
TEST_CASE("sandbox: other calling conventions of the processor kill the process") {
    if (is_sanitized()) {
        WARN("skipped: a sanitizer's filter lets more through");
        return;
    }
    CHECK(was_killed([](int) { syscall(0x40000000 + SYS_getpid); }));  // x32
    CHECK(was_killed([](int) {
        long result = 20;  // getpid by the 32-bit way, where the number means another call
        asm volatile("int $0x80" : "+a"(result) : : "memory");
    }));
}
#endif

TEST_CASE("sandbox: what a lesson needs is let through") {
    CHECK(was_let([](int socket) {
        if (send(socket, "hello", 5, MSG_NOSIGNAL) != 5) {
            _exit(2);
        }
    }));
    CHECK(was_let([](int) {
        void* volatile block = std::malloc(1U << 20U);
        std::free(block);
    }));
    CHECK(was_let([](int) {
        timespec now{};
        syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &now);
    }));
    CHECK(was_let([](int) {
        try {
            throw std::string("exceptions work");
        } catch (const std::string&) {
        }
    }));
}

TEST_CASE("sandbox: address space beyond the limit is refused, not given") {
    if (is_sanitized()) {
        WARN("skipped: a sanitizer's shadow needs all address space");
        return;
    }
    CHECK(was_let([](int) {
        if (mmap(nullptr, 32U << 20U, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) !=
            MAP_FAILED) {
            _exit(3);
        }
    }));
}

TEST_CASE("sandbox: a lower limit that whoever started it has set stays") {
    if (is_sanitized()) {
        WARN("skipped: a sanitizer's shadow needs all address space");
        return;
    }
    const int status = run_in_sandbox(
        [](int) {
            if (mmap(nullptr, 8U << 20U, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1,
                     0) != MAP_FAILED) {
                _exit(3);
            }
        },
        [] {
            rlim_t mapped_pages = 0;
            std::ifstream("/proc/self/statm") >> mapped_pages;
            const rlim_t lower =
                mapped_pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (4U << 20U);
            const rlimit both{lower, lower};
            setrlimit(RLIMIT_AS, &both);
        });
    CHECK((WIFEXITED(status) && WEXITSTATUS(status) == kAllowed));
}

TEST_CASE("sandbox: an open file of the program is closed before") {
    const int secret = open("/etc/hostname", O_RDONLY);
    const int status = run_in_sandbox([](int) {});
    CHECK((WIFEXITED(status) && WEXITSTATUS(status) == kAllowed));
    // The same closing, looked at from inside, without the filter.
    const pid_t pid = fork();
    if (pid == 0) {
        const bool closed =
            close_all_files_but(secret + 1, secret + 2) && fcntl(secret, F_GETFD) == -1;
        _exit(closed ? kAllowed : 1);
    }
    int after = 0;
    REQUIRE(waitpid(pid, &after, 0) == pid);
    CHECK((WIFEXITED(after) && WEXITSTATUS(after) == kAllowed));
    close(secret);
}

}  // namespace
}  // namespace fulcrum::runtime
