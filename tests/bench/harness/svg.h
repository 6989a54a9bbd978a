// Draws an exhibit: one SVG, no script, no font of its own; colour is never the only difference between two lines.
#pragma once

#include "tests/bench/harness/report.h"

#include <string>
#include <string_view>

namespace fulcrum::bench {

/// The picture: for a CostCurve error over median time with the Pareto front (grey steps, knob values beside it), tails to
/// the 99 % as thin lines, unstable settings as crosses on the upper edge, and a ring around the default; for a LineChart
/// its lines, theory dashed. Empty for a Sheet.
[[nodiscard]] std::string draw_svg(const Exhibit& exhibit);

/// Text with & < > " as XML wants them.
[[nodiscard]] std::string escape_xml(std::string_view text);

}  // namespace fulcrum::bench
