// Starts another program with its standard input and output where they are wanted: no shell, no terminal, its errors nowhere.
//
// Of the environment it gets the search path, the folders of libraries and what sanitizers need; it has a process group of its own, no
// signal blocked or ignored, and ordinary scheduling, whatever thread starts it.
//
// Thread: any. Cost: the start of a process, 1 to 3 ms.
#pragma once

#include <spawn.h>
#include <string>
#include <sys/types.h>
#include <vector>

namespace fulcrum::runtime {

/// A process group of its own (a Ctrl-C is for the program), no signal blocked or ignored, ordinary scheduling, whatever thread starts it.
void set_apart(posix_spawnattr_t& attributes);

/// A process, killed with all that it started and waited for when this goes.
class StartedProgram {
  public:
    StartedProgram() = default;
    StartedProgram(const StartedProgram&) = delete;
    StartedProgram& operator=(const StartedProgram&) = delete;
    ~StartedProgram();

    /// `words`: the program's name or path, then its arguments. `input`: a descriptor, below 0 for an empty one; both stay the caller's to
    /// close. `kept`: how further entries of the environment begin that it gets, "HOME=". 0, or the system's number for what went
    /// wrong. Once.
    [[nodiscard]] int start(const std::vector<std::string>& words, int input, int output,
                            const std::vector<std::string>& kept = {});
    /// Kills it with all that it started, and waits for its end; nothing where it has ended.
    void end();
    /// Whether it ends by itself until then, on the monotonic clock, and well.
    [[nodiscard]] bool ends_well(double end_s);

  private:
    pid_t pid_ = -1;
};

}  // namespace fulcrum::runtime
