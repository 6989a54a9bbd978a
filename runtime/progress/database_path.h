// Where the learners' database lies on this computer.
#pragma once

#include "haptics/base/error.h"

#include <string>

namespace fulcrum::runtime {

/// $XDG_DATA_HOME/fulcrum/progress.db, or ~/.local/share/fulcrum/progress.db when that is unset or
/// not absolute (XDG Base Directory Specification). Nothing is made. Refuses when neither it nor a
/// home folder is known.
[[nodiscard]] Expected<std::string> default_database_path();

/// Makes the folders that `path` needs (mode 0700) and the file, empty (mode 0600), and syncs each
/// folder that got a new entry, so that a power cut doesn't take them away. What exists already is
/// left alone.
[[nodiscard]] Expected<void> create_private_file(const std::string& path);

}  // namespace fulcrum::runtime
