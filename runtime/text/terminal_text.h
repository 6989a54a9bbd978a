// How much of a text fits into a line of a terminal.
//
// Thread: any. Cost: linear.
// Source: The Unicode Standard 15.0, 2022, annex 11 (East Asian width: what is wide or full takes two columns).
#pragma once

#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// The beginning of `utf8` that takes no more than `columns`, whole characters, on one line; what a terminal would obey instead of
/// show is left out, and bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string fit_to_columns(std::string_view utf8, int columns);

}  // namespace fulcrum::runtime
