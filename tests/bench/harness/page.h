// One self-contained HTML page of everything that a run found: no script, no other file, no network.
#pragma once

#include "tests/bench/harness/environment.h"
#include "tests/bench/harness/report.h"

#include <string>
#include <vector>

namespace fulcrum::bench {

/// The page. `peers` says which other libraries took part and which were not built, a sentence each.
[[nodiscard]] std::string make_page(const Report& exhibits, const Environment& environment,
                                    const std::vector<std::string>& peers);

}  // namespace fulcrum::bench
