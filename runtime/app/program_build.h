// Which program this is: for `--version` and for every record.
#pragma once

#include <string>

namespace fulcrum::runtime {

inline constexpr const char* kProgramVersion = "0.1.0";

/// The build id of this very program, hexadecimal: other code or another compiler, another id; stripping keeps it (cmake/build_id.sh).
/// "unknown" where the linker left no room for one.
[[nodiscard]] std::string program_build_id();

}  // namespace fulcrum::runtime
