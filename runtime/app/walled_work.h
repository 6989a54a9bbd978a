// Work on what a lesson holds, in a process of its own: whatever it runs into there, a crash, a loop that takes for ever, a flood of
// memory, is one sentence here that says what was being looked at.
//
//   fork -> limits of processor time and of addresses -> work, which tells its stages -> its exit code
//   ended by a signal -> the sentence, with the last stage that was told, and exit code 2
// What it says goes where this process' words go. Somebody at a terminal is told of a stage that begins after kTold_s, so that long work
// shows that it goes on. Ctrl-C and SIGTERM end both.
//
// Thread: one, and no other may run when it begins. Source: fork(2), setrlimit(2).
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace fulcrum::runtime {

/// What the work tells of itself.
class StageTeller {
  public:
    static constexpr double kTold_s = 2.0;
    static constexpr std::size_t kMostBytes = 200;

    /// `page`: kMostBytes that both processes see. `subject`: what is worked on, as the lines of progress begin.
    StageTeller(char* page, std::string subject);
    /// What is looked at from now on: "question heavy, lesson.lua:12".
    void begin(const std::string& stage);

  private:
    char* page_;
    std::string subject_;
    bool is_watched_;
    double began_s_;
};

struct WorkWalls {
    double cpu_s = 120.0;
    std::size_t address_bytes = std::size_t{4}
                                << 30;  ///< not in a build with sanitizers, which take more
};

/// The work's exit code; 2 where it was ended, which has been told then.
[[nodiscard]] int run_walled(const std::string& subject, const WorkWalls& walls,
                             const std::function<int(StageTeller&)>& work);

}  // namespace fulcrum::runtime
