// A strict reader of RFC 4180, so that tests see what a spreadsheet would.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fulcrum {

/// Rows of cells; nothing when the text is no CSV (a bare quote, a bare line end, no CR LF at the
/// end).
[[nodiscard]] std::optional<std::vector<std::vector<std::string>>> parse_csv(
    const std::string& text);

}  // namespace fulcrum
