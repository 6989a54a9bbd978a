// Which program this is: for `--version` and for every record.
#pragma once

#include <string>

namespace fulcrum::runtime {

inline constexpr const char* kProgramVersion = "0.1.0";

/// The build id that the linker gave this very program, hexadecimal: other code or another compiler, another id. "unknown" where it gave none.
[[nodiscard]] std::string program_build_id();

}  // namespace fulcrum::runtime
