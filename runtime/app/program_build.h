// Which program this is: for `--version` and for every record.
#pragma once

#include <string>

namespace fulcrum::runtime {

inline constexpr const char* kProgramVersion = "0.1.0";

/// The least processor that this program's instructions are for (FULCRUM_PORTABLE).
#if defined(__AVX2__) && defined(__FMA__) && defined(__BMI2__)
inline constexpr const char* kProgramProcessor = "x86-64-v3";
#elif defined(__x86_64__)
inline constexpr const char* kProgramProcessor = "x86-64";
#elif defined(__aarch64__)
inline constexpr const char* kProgramProcessor = "arm64";
#else
inline constexpr const char* kProgramProcessor = "unknown";
#endif

/// The build id that the linker gave this very program, hexadecimal: other code or another compiler, another id. "unknown" where it gave none.
[[nodiscard]] std::string program_build_id();

}  // namespace fulcrum::runtime
