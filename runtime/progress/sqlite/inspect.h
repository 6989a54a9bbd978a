// The look before a database is opened for writing: is it sound, ours, and not newer than we are?
#pragma once

#include "runtime/progress/sqlite/database.h"

#include <string>

namespace fulcrum::runtime::sqlite {

/// Refuses, in one sentence, a file that is damaged, newer than `kSchemaVersion`, without a column that its version has, or
/// another program's. Accepts an empty one. The file and its log stay as they are, byte for byte; without a
/// log beside it, nothing new appears either.
void inspect(const std::string& path, const std::string& vfs, int busy_timeout_ms);

}  // namespace fulcrum::runtime::sqlite
