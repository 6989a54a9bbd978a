// Where and from what figures came: stands at the head of each CSV file.
#pragma once

#include <string>

namespace fulcrum::bench {

struct Environment {
    std::string commit;    ///< of the source that was built, "+" after it when it had been changed
    std::string compiler;  ///< name, version, build type
    std::string cpu;
    std::string command;  ///< as it can be typed again
    std::string date;     ///< UTC day, 2026-01-31
};

/// Looks it up; what cannot be found is "unknown". `command` is taken as it is.
[[nodiscard]] Environment find_environment(const std::string& command);

}  // namespace fulcrum::bench
