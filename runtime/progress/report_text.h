// A report for a teacher to read, in 80 columns: first who is stuck now, then learner by learner.
//
// Thread: any. Cost: in proportion to the report.
#pragma once

#include "runtime/progress/report.h"
#include "runtime/progress/report_cells.h"

#include <string>

namespace fulcrum::runtime {

/// For a terminal or paper, 80 columns; an empty report is one friendly sentence. Ends with a
/// newline.
[[nodiscard]] std::string to_text(const Report& report, const ReportStyle& style = {});

}  // namespace fulcrum::runtime
