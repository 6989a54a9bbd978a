// The SQL behind each operation of the store. Each function runs inside a transaction of the
// caller's.
#pragma once

#include "runtime/progress/sqlite/database.h"
#include "runtime/progress/store.h"

namespace fulcrum::runtime::sqlite {

/// The learner of this (checked) nickname, added if there is none.
[[nodiscard]] Learner enrol(Database& database, const std::string& nickname);

/// Adds a (validated) record. One that is there already with the same content is left; with other
/// content, refused.
void keep(Database& database, const Learner& learner);
void keep(Database& database, const SessionRecord& session);
void keep(Database& database, const SessionSetting& setting);
void keep(Database& database, const HandSetting& setting);
void keep(Database& database, const SessionEnd& end);
void keep(Database& database, const AttemptRecord& attempt);

/// Everything that the filter matches.
[[nodiscard]] ProgressData read(Database& database, const ProgressFilter& filter);

}  // namespace fulcrum::runtime::sqlite
