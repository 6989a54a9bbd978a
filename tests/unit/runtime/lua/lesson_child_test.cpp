#include "runtime/lua/lesson_process.h"

#include <catch2/catch.hpp>

#include <array>
#include <string>
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
    const pid_t pid = fork();
    if (pid == 0) {
        execl(FULCRUM_LESSON_HELPER, "helper", "--lesson-process", number,
              static_cast<char*>(nullptr));
        _exit(99);
    }
    int status = 0;
    REQUIRE(waitpid(pid, &status, 0) == pid);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_CASE("lesson child: started by hand it ends at once") {
    CHECK(exit_code_with("x") == 1);
    CHECK(exit_code_with("0") == 1);
    CHECK(exit_code_with("900") == 1);
}

}  // namespace
}  // namespace fulcrum::runtime
