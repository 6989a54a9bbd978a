#include "runtime/lua/process/child_process.h"

#include "tests/unit/runtime/lua/lesson_helper.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMemory = 4U << 20U;

int open_files() {
    int n = 0;
    for ([[maybe_unused]] const auto& entry :
         std::filesystem::directory_iterator("/proc/self/fd")) {
        ++n;
    }
    return n;
}

TEST_CASE(
    "child process: starts, waits for its first message, uses little time, and is ended and "
    "reaped") {
    const int files_before = open_files();
    {
        auto child = ChildProcess::start(test::lesson_helper(), kMemory);
        REQUIRE(child);
        const pid_t pid = (*child)->pid();
        CHECK(pid > 0);
        CHECK(getpgid(pid) == pid);  // a Ctrl-C does not reach it
        CHECK((*child)->cpu_s() < 10.0);
        const ProcessEnd end = (*child)->end();
        CHECK(end.by_signal);
        CHECK(end.code == SIGKILL);
        CHECK((*child)->end().code == SIGKILL);  // the same each time
        CHECK((*child)->pid() == -1);
        CHECK((*child)->cpu_s() == 0.0);
        CHECK(waitpid(pid, nullptr, WNOHANG) == -1);
        CHECK((*child)->last_seen().line == 0);
    }
    CHECK(open_files() == files_before);
}

TEST_CASE("child process: how a process ended by itself is known") {
    auto child = ChildProcess::start("/bin/false", kMemory);
    REQUIRE(child);
    (*child)->wait_readable(30.0);  // the other end closes
    siginfo_t info{};
    waitid(P_PID, static_cast<id_t>((*child)->pid()), &info, WEXITED | WNOWAIT);
    const ProcessEnd end = (*child)->end();
    CHECK_FALSE(end.by_signal);
    CHECK(end.code == 1);
}

TEST_CASE("child process: the processor time it used to start is seen") {
    auto child = ChildProcess::start(test::lesson_helper(), kMemory);
    REQUIRE(child);
    double used_s = 0.0;
    for (int i = 0; i < 10'000 && used_s == 0.0; ++i) {
        (*child)->wait_readable(0.001);
        used_s = (*child)->cpu_s();
    }
    CHECK(used_s > 0.0);
}

TEST_CASE("child process: an executable that is not there is an error, and leaves nothing open") {
    const int files_before = open_files();
    CHECK_FALSE(ChildProcess::start("/nonexistent", kMemory));
    CHECK(open_files() == files_before);
}

}  // namespace
}  // namespace fulcrum::runtime
