// The key that a program and its arm share: 64 hexadecimal figures in a file that only its user can read.
//
// On one computer both find it by themselves: it is made where it is missing. For an arm on another computer the file is copied.
//
// Thread: load.
#pragma once

#include "haptics/base/error.h"
#include "runtime/link/sodium_seal.h"

#include <filesystem>
#include <string>

namespace fulcrum::runtime {

/// Where it lies: where `given` says, or else $XDG_CONFIG_HOME/fulcrum/arm.key, or below the home folder.
[[nodiscard]] Expected<std::filesystem::path> find_arm_key_file(const std::string& given);

/// Reads it; makes it where there is none. Refuses a file that others may read or write, or that holds anything else.
[[nodiscard]] Expected<ArmKey> load_or_make_arm_key(const std::filesystem::path& file);

}  // namespace fulcrum::runtime
