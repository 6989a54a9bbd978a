// A record as tables for a spreadsheet or a script: the rounds, and beside them events, bodies and what the run was made with.
//
//   NAME.csv          a round a row       NAME.events.csv   an event a row
//   NAME.bodies.csv   a place a row       NAME.facts.csv    a fact a row
// RFC 4180: rows end in CR LF, a cell with a separator, quote or line end stands in quotes. The unit stands in a column's name. A number has
// as many digits as it takes to read the same one again, at most 17.
// All four are written beside their places and take them when they are whole: whatever goes wrong, none is there by half.
//
// Thread: load path. Cost: 3 us a round.
#pragma once

#include "haptics/base/error.h"
#include "haptics/record/record.h"

#include <filesystem>
#include <functional>
#include <string>

namespace fulcrum::runtime {

/// Told how much is done, 0 to 1; false stops it.
using ExportProgress = std::function<bool(double share)>;

/// Writes all tables; those that are there are replaced. Refuses a place that cannot be written to, and what was stopped.
[[nodiscard]] Expected<void> export_record(const Record& record, const std::filesystem::path& file,
                                           const ExportProgress& progress = {});

// The tables' texts, for tests.
[[nodiscard]] std::string sample_header(const Record& record);
[[nodiscard]] std::string sample_row(const Record& record, std::size_t sample);

}  // namespace fulcrum::runtime
