#include "runtime/files/start_program.h"

#include "haptics/base/clock.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <string_view>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

std::vector<std::string> passed_environment(std::vector<std::string> begins) {
    begins.insert(begins.end(), {"PATH=", "LD_LIBRARY_PATH=", "ESPEAK_DATA_PATH=", "ASAN_OPTIONS=",
                                 "UBSAN_OPTIONS=", "TSAN_OPTIONS="});
    std::vector<std::string> passed;
    for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
        if (std::ranges::any_of(begins, [&](const std::string& begin) {
                return std::string_view(*entry).starts_with(begin);
            })) {
            passed.emplace_back(*entry);
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

}  // namespace

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

StartedProgram::~StartedProgram() {
    end();
}

void StartedProgram::end() {
    if (pid_ >= 0) {
        kill(-pid_, SIGKILL);  // what it started, too
        kill(pid_, SIGKILL);
        while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
        }
        pid_ = -1;
    }
}

int StartedProgram::start(const std::vector<std::string>& words, int input, int output,
                          const std::vector<std::string>& kept) {
    std::vector<std::string> arguments = words;
    std::vector<std::string> environment = passed_environment(kept);
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    if (input < 0) {
        posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    } else {
        posix_spawn_file_actions_adddup2(&actions, input, 0);
    }
    posix_spawn_file_actions_adddup2(&actions, output, 1);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    set_apart(attributes);
    const int error = posix_spawnp(&pid_, words.front().c_str(), &actions, &attributes,
                                   pointers_to(arguments).data(), pointers_to(environment).data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        pid_ = -1;
    }
    return error;
}

// Who closes his output may still go on.
bool StartedProgram::ends_well(double end_s) {
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

}  // namespace fulcrum::runtime
