// Runs another program to its end and takes what it wrote: no shell, no terminal, nothing of it left behind.
//
// Its standard input is empty and its errors go nowhere. Of the environment it gets the search path, the folders of libraries and
// what sanitizers need. It is killed when it takes too long, writes too much, or nobody wants its answer any more.
//
// Thread: any that may wait, never a loop's. Cost: the start of a process, 1 to 3 ms, and its own time.
#pragma once

#include "haptics/base/error.h"

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

namespace fulcrum::runtime {

struct ProgramOrder {
    std::vector<std::string> words;  ///< the program's name or path, then its arguments
    std::size_t most_bytes = 0;      ///< of what it writes
    double most_s = 0.0;             ///< that it may take
};

/// What the program wrote. An error when it is not there, fails, is cut short by one of the limits, or `cancelled` becomes true.
[[nodiscard]] Expected<std::string> run_program(const ProgramOrder& order,
                                                const std::atomic<bool>& cancelled);

}  // namespace fulcrum::runtime
