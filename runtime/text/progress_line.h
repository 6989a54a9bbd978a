// One line on a terminal that says how far something long has come, and goes when it is done.
//
// Nothing is shown for what is over within `after_s`, and nothing at all where the stream is no terminal: logs stay quiet.
// The line is written anew at most every `between_s`, and is never longer than the terminal is wide.
//
// Thread: one. Cost: a look at the clock a call, 0.1 ms where it writes.
#pragma once

#include "haptics/base/parallel_for.h"

#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

struct ProgressLineSettings {
    double after_s = 0.5;        ///< before that it stays silent
    double between_s = 0.05;     ///< it is written anew no sooner
    std::FILE* stream = stderr;  ///< shown where this is a terminal
};

class ProgressLine {
  public:
    /// `label` stands before the number.
    explicit ProgressLine(std::string label, const ProgressLineSettings& settings = {});
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine() { clear(); }

    /// Takes the line away, until something is said again.
    void clear();
    /// "label  42 % what"; the share from 0 to 1, of `what`, in UTF-8 or any bytes, what fits.
    void say(double share, std::string_view what = {});
    [[nodiscard]] bool is_on_terminal() const noexcept { return on_terminal_; }

  private:
    using Clock = std::chrono::steady_clock;

    std::string label_;
    ProgressLineSettings settings_;
    bool on_terminal_;
    bool is_shown_ = false;
    Clock::time_point begun_ = Clock::now();
    Clock::time_point last_{};
};

}  // namespace fulcrum::runtime
