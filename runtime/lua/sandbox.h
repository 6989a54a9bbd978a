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

#include "haptics/base/error.h"

#include <cstddef>

namespace fulcrum::runtime {

struct SandboxSettings {
    int socket = -1;  ///< the one open file that may be read and written
    std::size_t more_memory_bytes =
        64U << 20U;  ///< address space that may still be mapped, beyond what is mapped now
};

/// Closes every file but `keep` and `keep_too` (standard input, output and errors become
/// /dev/null). Error when it can't.
[[nodiscard]] Expected<void> close_all_files_but(int keep, int keep_too);

/// Puts up all walls. Error when the kernel refuses one; then no lesson may be run.
[[nodiscard]] Expected<void> enter_sandbox(const SandboxSettings& settings);

}  // namespace fulcrum::runtime
