// The SQL behind each operation of the store. Each function runs inside a transaction of the
// caller's.
#pragma once

#include "runtime/progress/sqlite/database.h"
#include "runtime/progress/store.h"

#include <optional>
#include <string>

namespace fulcrum::runtime::sqlite {

/// Whom a nickname means: the learner of that very name, as it is or in NFC (but for capitals of ASCII), else the first enrolled whose name folds to the same
/// (folded_nickname). Two names that were kept apart are so both still found.
[[nodiscard]] std::optional<Learner> find_called(Database& database, const std::string& nickname);

/// The learner whom this (checked) nickname means, added if there is none.
[[nodiscard]] Learner enrol(Database& database, const std::string& nickname);

/// Adds a (validated) record. One that is there already with the same content is left; with other
/// content, refused.
void keep(Database& database, const Learner& learner);
void keep(Database& database, const SessionRecord& session);
void keep(Database& database, const SessionSetting& setting);
void keep(Database& database, const HandSetting& setting);
void keep(Database& database, const SessionEnd& end);
void keep(Database& database, const AttemptRecord& attempt);
void keep(Database& database, const ClassRows& rows);

/// Everything that the filter matches.
[[nodiscard]] ProgressData read(Database& database, const ProgressFilter& filter);
/// All of classes.
[[nodiscard]] ClassRows read_classes(Database& database);

}  // namespace fulcrum::runtime::sqlite
