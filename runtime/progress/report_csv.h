// A report for spreadsheets.
//
// Thread: any. Cost: in proportion to the report.
#pragma once

#include "runtime/progress/report.h"
#include "runtime/progress/report_cells.h"

#include <string>

namespace fulcrum::runtime {

/// RFC 4180: a header, then a row for each learner, lesson and question (fewer cells filled when
/// there is no lesson or question yet). Cells that a spreadsheet would take for a formula begin
/// with an apostrophe.
[[nodiscard]] std::string to_csv(const Report& report, const ReportStyle& style = {});

}  // namespace fulcrum::runtime
