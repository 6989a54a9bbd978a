#include "runtime/progress/report_cells.h"

#include <array>
#include <ctime>

namespace fulcrum::runtime {

std::string time_cell(std::int64_t utc_ms, const ReportStyle& style) {
    const std::int64_t utc_s = utc_ms >= 0 ? utc_ms / 1000 : (utc_ms - 999) / 1000;
    const auto time = static_cast<std::time_t>(utc_s);
    std::tm parts{};  // any number of milliseconds has a year that fits
    style.utc ? gmtime_r(&time, &parts) : localtime_r(&time, &parts);
    std::array<char, 40> text{};
    const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M %z", &parts);
    return {text.data(), size};
}

const char* stuck_cell(Stuck stuck) noexcept {
    switch (stuck) {
        case Stuck::now:
            return "now";
        case Stuck::before:
            return "before";
        case Stuck::no:
            break;
    }
    return "no";
}

std::string error_cell(const FormErrorReport& error) {
    return error.code + " " + std::to_string(error.count);
}

std::string example_cell(const FormErrorReport& error) {
    return '"' + error.span + "\" -> \"" + error.correction + '"';
}

}  // namespace fulcrum::runtime
