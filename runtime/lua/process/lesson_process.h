// A lesson in a process of its own, seen from the program: start it, exchange a frame for a reply,
// end it.
//
// The process is the program's own file started again with `--lesson-process FD`; it closes itself
// off (sandbox.h) before it reads a word of the lesson. What a lesson does there, hang, crash,
// gorge, ends in one Error here, with file and line where a line is known. A process that has not
// answered after `answer_cpu_s` of its own processor time is killed; the clock on the wall ends none,
// so a busy machine does not end an innocent lesson. Whoever waits may give it up.
//
// Thread: all calls from one thread, and the thread that called `start` must outlive the object
// (the kernel ends the process with that thread). Cost: start about 10 ms; exchange about 50 us for
// a small scene; send and poll do not wait.
#pragma once

#include "haptics/base/error.h"
#include "runtime/lua/process/lesson_sources.h"
#include "runtime/scene/description.h"
#include "runtime/scene/lesson_messages.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace fulcrum::runtime {

/// Call this first thing in main(), before anything is set up: when the program was started as a
/// lesson's process it gives the inherited socket for `lesson_process_main`.
[[nodiscard]] std::optional<int> lesson_process_socket(int argc, char** argv);
/// The life of a lesson's process; returns its exit code. Never throws.
[[nodiscard]] int lesson_process_main(int socket);

struct LessonProcessOptions {
    std::string executable =
        "/proc/self/exe";                   ///< its main() must do as said at lesson_process_socket
    std::uint64_t seed = 1;                 ///< of math.random
    std::size_t memory_bytes = 64U << 20U;  ///< that Lua may use, 1 to 256 MiB
    double load_cpu_s = 0.5;                ///< processor time for loading and start()
    double answer_cpu_s = 0.1;              ///< processor time for one frame
    /// Asked every now and then by `start` and `exchange` while they wait, with the seconds that they have waited; false gives the
    /// process up. Empty: they wait on.
    std::function<bool(double)> waits_on;
    std::uint64_t load_instructions = 20'000'000;  ///< Lua's own, friendlier limit; 0 for none
    std::uint64_t frame_instructions = 3'000'000;
};

class LessonProcess {
  public:
    /// Reads the files, starts the process, loads the lesson and runs its start(). Error: what is
    /// wrong with the lesson.
    [[nodiscard]] static Expected<std::unique_ptr<LessonProcess>> start(
        const LessonFiles& files, const LessonProcessOptions& options = {});
    LessonProcess(const LessonProcess&) = delete;
    LessonProcess& operator=(const LessonProcess&) = delete;
    /// Ends the process and waits until it is gone.
    ~LessonProcess();

    /// What the lesson declared.
    [[nodiscard]] const LessonDescription& description() const noexcept;
    /// What print() said while loading.
    [[nodiscard]] const std::vector<std::string>& prints_while_loading() const noexcept;
    /// Every file the lesson was made from, for --watch.
    [[nodiscard]] const std::vector<std::filesystem::path>& files_read() const noexcept;

    /// Sends a frame and waits for the reply. After an Error the process is gone and every further
    /// call fails alike.
    [[nodiscard]] Expected<LessonReply> exchange(const LessonFrame& frame);

    /// Sends a frame without waiting. One frame at a time: an Error when the last was not answered
    /// yet.
    [[nodiscard]] Expected<void> send(const LessonFrame& frame);
    /// The reply to the last frame sent, once it is there; nothing while the lesson still thinks;
    /// an Error when it failed or took too long (then the process is gone). Does not wait.
    [[nodiscard]] std::optional<Expected<LessonReply>> poll();
    /// True between `send` and the reply.
    [[nodiscard]] bool waits_for_reply() const noexcept;
    /// Since when, in seconds; 0 where it waits for none.
    [[nodiscard]] double waited_s() const noexcept;

    /// The process, for measuring; -1 once it is gone.
    [[nodiscard]] pid_t pid() const noexcept;

  private:
    struct Parts;
    explicit LessonProcess(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace fulcrum::runtime
