#include "runtime/lua/process/lesson_process.h"
#include "runtime/lua/sandbox/sandbox.h"
#include "tests/unit/runtime/lua/lesson_folder.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <string>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace fulcrum::runtime {
namespace {

std::optional<int> socket_of(std::vector<std::string> arguments) {
    std::vector<char*> pointers;
    for (std::string& argument : arguments) {
        pointers.push_back(argument.data());
    }
    return lesson_process_socket(static_cast<int>(pointers.size()), pointers.data());
}

TEST_CASE("lesson child: only the hidden argument makes a lesson's process") {
    CHECK_FALSE(socket_of({"fulcrum"}));
    CHECK_FALSE(socket_of({"fulcrum", "run", "gravity"}));
    CHECK_FALSE(socket_of({"fulcrum", "--lesson-process"}));
    CHECK_FALSE(socket_of({"fulcrum", "--lesson-process", "3", "4"}));
    CHECK(socket_of({"fulcrum", "--lesson-process", "3"}) == 3);
    CHECK(socket_of({"fulcrum", "--lesson-process", "x"}) == -1);
    CHECK(socket_of({"fulcrum", "--lesson-process", "3x"}) == -1);
}

/// The exit code of the program started as a lesson's process by hand, with a number but nothing behind it.
int exit_code_with(const char* number) {
    const std::string program = test::lesson_helper();
    const pid_t pid = fork();
    if (pid == 0) {
        execl(program.c_str(), "helper", "--lesson-process", number, static_cast<char*>(nullptr));
        _exit(99);
    }
    int status = 0;
    REQUIRE(waitpid(pid, &status, 0) == pid);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_CASE("lesson child: started by hand it ends at once") {
    CHECK(exit_code_with("x") == 1);
    CHECK(exit_code_with("0") == 1);
    CHECK(exit_code_with("900") == kWallExitCode + static_cast<int>(Wall::page));
}

/// The sentence of a lesson that is started where the system refuses the call of that number.
std::string sentence_without(long number) {
    const test::LessonFolder folder;
    std::array<int, 2> ends{};
    REQUIRE(pipe(ends.data()) == 0);
    const pid_t pid = fork();
    REQUIRE(pid >= 0);
    if (pid == 0) {
        std::array<sock_filter, 4> filter = {
            sock_filter{BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
            sock_filter{BPF_JMP | BPF_JEQ | BPF_K, 0, 1, static_cast<std::uint32_t>(number)},
            sock_filter{BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | ENOSYS},
            sock_filter{BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW}};
        const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
        if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
            prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) {
            _exit(1);
        }
        const auto process = folder.start(test::lesson_text(""));
        const std::string said = process ? "started" : to_sentence(process.error());
        _exit(write(ends[1], said.data(), said.size()) == static_cast<ssize_t>(said.size()) ? 0
                                                                                            : 1);
    }
    close(ends[1]);
    std::array<char, 1000> said{};
    const ssize_t n = read(ends[0], said.data(), said.size());
    close(ends[0]);
    int status = 0;
    REQUIRE(waitpid(pid, &status, 0) == pid);
    return {said.data(), static_cast<std::size_t>(std::max<ssize_t>(n, 0))};
}

TEST_CASE("lesson child: where a wall can't be put up, the sentence says which") {
    constexpr const char* kWhatToDo =
        "; use Linux 5.9 or later, in a container only one that allows seccomp.";
    CHECK(sentence_without(SYS_getpgid) == "started");
    CHECK(sentence_without(SYS_close_range) ==
          std::string("no lesson can be run safely here: the system can't close its files "
                      "(close_range)") +
              kWhatToDo);
    CHECK(sentence_without(SYS_seccomp) ==
          std::string("no lesson can be run safely here: the system can't filter system calls "
                      "(seccomp)") +
              kWhatToDo);
    for (int wall = 0; wall < kWalls; ++wall) {
        CHECK(std::string(wall_text(static_cast<Wall>(wall))).size() > 10);
    }
}

}  // namespace
}  // namespace fulcrum::runtime
