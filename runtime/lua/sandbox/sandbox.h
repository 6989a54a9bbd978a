// The walls round a lesson's process: what it can do after `enter_sandbox` is read and write one
// socket, compute, and end.
//
// Every other system call kills the process (seccomp filter, written out in sandbox.cpp). Behind it
// stand limits on memory, files and processes, no rights of root, no new rights, and no tracing.
// The filter can't be taken off again.
//
// Thread: the only one of the process, before any text of a lesson is read. Cost: once, < 1 ms.
// Source: Linux Documentation/userspace-api/seccomp_filter.rst; seccomp(2), prctl(2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <tl/expected.hpp>

namespace fulcrum::runtime {

struct SandboxSettings {
    int socket = -1;  ///< the one open file that may be read and written
    std::size_t more_memory_bytes =
        64U << 20U;  ///< address space that may still be mapped, beyond what is mapped now
};

/// What the system refused. The lesson's process has no other word for it than its exit code, kWallExitCode + wall.
enum class Wall : std::uint8_t {
    page,           ///< the page that is shared with the program can't be mapped
    files,          ///< open files can't be closed: close_range, Linux 5.9
    memory,         ///< how much memory is in use can't be read: /proc
    limits,         ///< setrlimit
    rights,         ///< root's rights can't be given up
    no_new_rights,  ///< prctl
    filter,         ///< no seccomp filter
};
inline constexpr int kWalls = 7;
inline constexpr int kWallExitCode = 100;

/// What is missing, for people: "the system can't filter system calls (seccomp)".
[[nodiscard]] const char* wall_text(Wall wall);

template <class T>
using Walled = tl::expected<T, Wall>;

/// Closes every file but `keep` and `keep_too` (standard input, output and errors become
/// /dev/null). The wall when it can't.
[[nodiscard]] Walled<void> close_all_files_but(int keep, int keep_too);

/// Puts up all walls. The one that the kernel refuses, if any; then no lesson may be run.
[[nodiscard]] Walled<void> enter_sandbox(const SandboxSettings& settings);

}  // namespace fulcrum::runtime
