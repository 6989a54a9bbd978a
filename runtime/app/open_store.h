// Opens the learners' progress, or goes on without.
#pragma once

#include "runtime/progress/store.h"

#include <memory>
#include <string>

namespace fulcrum::runtime {

/// The store at `database` (empty: the default place).
[[nodiscard]] Expected<std::unique_ptr<ProgressStore>> open_store(const std::string& database);

/// The same, so that a lesson can always be played. One that cannot be used is left untouched: one sentence on the
/// terminal, and a store that keeps nothing.
/// Its writes wait for the disk: for a run without a window, whose clock waits with them.
[[nodiscard]] std::unique_ptr<ProgressStore> open_store_or_none(const std::string& database);

/// The same for a run with a window: writes go to the disk on a thread of their own, so that keys, and among them the
/// emergency stop, are read whatever the disk does.
[[nodiscard]] std::unique_ptr<ProgressStore> open_store_beside_window(const std::string& database);

}  // namespace fulcrum::runtime
