// Work in a program of its own, which has the test's memory and shares nothing with it.
#pragma once

#include <catch2/catch.hpp>

#include <cstdio>
#include <sched.h>
#include <string>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fulcrum::runtime {

/// Begins it; the program's end tells whether `work` was true.
template <class Work>
pid_t start_program(const Work& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::_exit(work() ? 0 : 1);
    }
    REQUIRE(child > 0);
    return child;
}

/// Whether it came to its end and was true.
inline bool wait_for_program(pid_t program) {
    int status = -1;
    return ::waitpid(program, &status, 0) == program && status == 0;
}

/// For a program of its own: puts a small disk of `kilobytes` at `folder`, which nobody else sees. False where that is not allowed.
inline bool put_small_disk(const std::string& folder, int kilobytes) {
    const std::string user = std::to_string(::geteuid());
    if (::unshare(CLONE_NEWNS) != 0) {
        if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) {
            return false;
        }
        std::FILE* map = std::fopen("/proc/self/uid_map", "w");
        if (map == nullptr) {
            return false;
        }
        std::fputs((user + ' ' + user + " 1").c_str(), map);
        if (std::fclose(map) != 0) {
            return false;
        }
    }
    const std::string options =
        "mode=0700,uid=" + user + ",size=" + std::to_string(kilobytes) + "k";
    return ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
           ::mount("tmpfs", folder.c_str(), "tmpfs", 0, options.c_str()) == 0;
}

}  // namespace fulcrum::runtime
