#include "runtime/text/progress_line.h"

#include "runtime/text/terminal_text.h"

#include <algorithm>
#include <array>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace fulcrum::runtime {
namespace {

// To the line's beginning, and away with what stands there.
constexpr const char* kEmptied = "\r\033[K";
constexpr int kMostColumns = 50;   // of what is done
constexpr int kUsualColumns = 80;  // where the terminal doesn't say

// Behind a full line some terminals begin another.
int find_columns(std::FILE* stream) {
    winsize size{};
    const bool is_told = ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return (is_told ? size.ws_col : kUsualColumns) - 1;
}

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
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), " %3.0f %% ", percent);
    const std::string line = label_ + number.data() + fit_to_columns(what, kMostColumns);
    std::fputs((kEmptied + fit_to_columns(line, find_columns(settings_.stream))).c_str(),
               settings_.stream);
    std::fflush(settings_.stream);
    is_shown_ = true;
    last_ = now;
}

}  // namespace fulcrum::runtime
