// The tables, as the list of steps that made them: step n brings a database from version n to n
// + 1. A new database goes through all of them, so every step is run every time. A released step is
// never changed.
#pragma once

#include "runtime/progress/sqlite/database.h"

#include <array>
#include <cstdint>

namespace fulcrum::runtime::sqlite {

/// Marks the file as Fulcrum's: "Fulc" in ASCII, in sqlite's application_id.
inline constexpr std::int64_t kApplicationId = 0x46756C63;

/// Version that this program writes; sqlite's user_version.
inline constexpr std::int64_t kSchemaVersion = 8;

/// SQL of each step.
[[nodiscard]] const std::array<const char*, kSchemaVersion>& migrations() noexcept;

/// Brings an empty or older database to `kSchemaVersion` in one transaction and notes that it was
/// opened. That note's commit syncs the whole log: what an earlier, killed program had written but
/// not synced is certain from here on.
void migrate(Database& database);

}  // namespace fulcrum::runtime::sqlite
