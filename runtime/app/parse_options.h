// The command line, read: what was asked for, or one sentence on what is wrong with it.
#pragma once

#include "runtime/app/options.h"

#include <span>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// Parses the words after the program's name. Unknown words name the nearest known one.
[[nodiscard]] Expected<Options> parse_options(std::span<const std::string> words);

/// What `fulcrum help` prints; of one command its part alone, where it has one.
[[nodiscard]] std::string usage(std::string_view command = {});

/// Smallest number of single-letter edits between two words (Levenshtein 1966), for "did you mean".
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

}  // namespace fulcrum::runtime
