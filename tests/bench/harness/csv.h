// An exhibit as CSV and back: the file holds all that the figure needs, so that figures are drawn from files alone.
//
//   # kind: cost                       then one "# key: value" a line
//   series,knob,error,median,p99,bytes,...      the columns of the kind, with their units in the head lines
// Texts with commas, quotes or line ends are quoted as in RFC 4180; a number that could not be had is empty.
#pragma once

#include "haptics/base/error.h"
#include "tests/bench/harness/environment.h"
#include "tests/bench/harness/report.h"

#include <string>
#include <string_view>

namespace fulcrum::bench {

/// The whole file.
[[nodiscard]] std::string to_csv(const Exhibit& exhibit, const Environment& environment);

/// Reads what `to_csv` wrote; `file` is its name for errors. The environment's lines are left out.
[[nodiscard]] Expected<Exhibit> read_csv(std::string_view text, const std::string& file);

/// The exhibit's file stem and title.
[[nodiscard]] const std::string& name_of(const Exhibit& exhibit);
[[nodiscard]] const std::string& title_of(const Exhibit& exhibit);

}  // namespace fulcrum::bench
