#include "tests/bench/harness/environment.h"

#include <array>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>

namespace fulcrum::bench {
namespace {

// The first line that a command prints; empty when it fails.
std::string first_line_of(const char* command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command, "r"), ::pclose);
    std::array<char, 256> line{};
    if (!pipe || std::fgets(line.data(), static_cast<int>(line.size()), pipe.get()) == nullptr) {
        return {};
    }
    std::string text = line.data();
    text.erase(text.find_last_not_of('\n') + 1);
    return text;
}

std::string find_commit() {
    const std::string source = FULCRUM_SOURCE_DIR;
    const std::string git = "git -C '" + source + "' ";
    const std::string commit =
        first_line_of((git + "rev-parse --short=10 HEAD 2>/dev/null").c_str());
    if (commit.empty()) {
        return "unknown";
    }
    const bool changed = !first_line_of((git + "status --porcelain 2>/dev/null").c_str()).empty();
    return changed ? commit + "+" : commit;
}

std::string find_cpu() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("model name")) {
            return line.substr(line.find(':') + 2);
        }
    }
    return "unknown";
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    ::gmtime_r(&now, &utc);
    std::array<char, 16> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &utc);
    return text.data();
}

}  // namespace

Environment find_environment(const std::string& command) {
    return {find_commit(), FULCRUM_COMPILER, find_cpu(), command, today()};
}

}  // namespace fulcrum::bench
