// Writes that may be repeated: what is there already under an id is left when it is the same, else refused.
#pragma once

#include "runtime/progress/records.h"
#include "runtime/progress/sqlite/database.h"

#include <optional>
#include <string>

namespace fulcrum::runtime::sqlite {

/// True when the record is there already, so that there is nothing to add.
template <class Record>
bool is_repeat(Database& database, const std::optional<Record>& kept, const Record& record,
               const char* what) {
    if (kept && *kept != record) {
        throw Refused({std::string("another ") + what + " is kept under this id", database.path(),
                       "give each one an id of its own"});
    }
    return kept.has_value();
}

/// Refuses what belongs to something that `sql` does not find under this id.
inline void require(Database& database, const char* sql, const RecordId& id, const char* what) {
    Statement row(database, sql);
    if (!row.bind(id).step()) {
        throw Refused({std::string("the ") + what + " " + id + " is not known", database.path(),
                       "keep it before what belongs to it"});
    }
}

}  // namespace fulcrum::runtime::sqlite
