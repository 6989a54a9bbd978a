// Opens the learners' progress, or goes on without.
#pragma once

#include "runtime/progress/store.h"

#include <memory>
#include <string>

namespace fulcrum::runtime {

/// The store at `database` (empty: the default place). One that cannot be used is left untouched: one sentence on the
/// terminal, and a store that keeps nothing, so that the lesson can still be played.
[[nodiscard]] std::unique_ptr<ProgressStore> open_store_or_none(const std::string& database);

}  // namespace fulcrum::runtime
