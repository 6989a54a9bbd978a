#include "runtime/files/progress_line.h"

#include <algorithm>
#include <unistd.h>
#include <utility>

namespace fulcrum::runtime {
namespace {

// To the line's beginning, and away with what stands there.
constexpr const char* kEmptied = "\r\033[K";
constexpr int kMostLetters = 50;

}  // namespace

ProgressLine::ProgressLine(std::string label, const ProgressLineSettings& settings)
    : label_(std::move(label)),
      settings_(settings),
      on_terminal_(::isatty(::fileno(settings.stream)) == 1) {}

void ProgressLine::clear() {
    if (is_shown_) {
        std::fputs(kEmptied, settings_.stream);
        std::fflush(settings_.stream);
    }
    is_shown_ = false;
}

void ProgressLine::say(double share, std::string_view what) {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> since = now - begun_;
    const std::chrono::duration<double> shown = now - last_;
    if (!on_terminal_ || since.count() < settings_.after_s ||
        (is_shown_ && shown.count() < settings_.between_s)) {
        return;
    }
    const double percent = 100.0 * std::clamp(share, 0.0, 1.0);
    const int letters = std::min(kMostLetters, static_cast<int>(what.size()));
    std::fprintf(settings_.stream, "%s%s %3.0f %% %.*s", kEmptied, label_.c_str(), percent, letters,
                 what.data());
    std::fflush(settings_.stream);
    is_shown_ = true;
    last_ = now;
}

}  // namespace fulcrum::runtime
