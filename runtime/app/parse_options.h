// The command line, read: what was asked for, or one sentence on what is wrong with it; and the help, both from option_table.h.
#pragma once

#include "runtime/app/options.h"

#include <span>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// Parses the words after the program's name. Unknown words name the nearest known one.
[[nodiscard]] Expected<Options> parse_options(std::span<const std::string> words);

/// What `fulcrum help` prints, where an option of several commands is described at the first; of one command its part alone, in full.
[[nodiscard]] std::string usage(std::string_view command = {});

}  // namespace fulcrum::runtime
