// Starts this program again as a lesson's process, watches it, and ends it.
//
// Thread: one; see lesson_process.h. Cost: start of a process; the rest a system call or two.
#pragma once

#include "haptics/base/error.h"
#include "runtime/lua/process/shared_page.h"

#include <memory>
#include <string>
#include <sys/types.h>

namespace fulcrum::runtime {

/// How a process ended.
struct ProcessEnd {
    bool by_signal = false;
    int code = 0;  ///< signal number or exit code
};

class ChildProcess {
  public:
    /// Starts `executable`. Error when the system refuses.
    [[nodiscard]] static Expected<std::unique_ptr<ChildProcess>> start(
        const std::string& executable, std::size_t memory_bytes);
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    ~ChildProcess();

    [[nodiscard]] int socket() const noexcept { return socket_; }
    [[nodiscard]] pid_t pid() const noexcept { return pid_; }
    /// Processor time the process has used so far, in seconds; 0 once it is gone.
    [[nodiscard]] double cpu_s() const noexcept;
    /// Waits until there is something to read, at most `timeout_s`.
    void wait_readable(double timeout_s) const noexcept;
    /// Waits until something can be written, at most `timeout_s`.
    void wait_writable(double timeout_s) const noexcept;
    /// Kills the process unless it has ended, and takes it off the system's list. How it ended; the same each time.
    ProcessEnd end() noexcept;
    /// Where its script was last seen: a line and the file's shown name, neither to be trusted.
    [[nodiscard]] ScriptError last_seen() const;

  private:
    ChildProcess() = default;
    void wait_for(short events, double timeout_s) const noexcept;

    int socket_ = -1;
    pid_t pid_ = -1;
    SharedPage* page_ = nullptr;
    ProcessEnd ended_{};
};

}  // namespace fulcrum::runtime
