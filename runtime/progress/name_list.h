// The names of a class, as a teacher writes them: one a line, or one a word of the command line.
//
//   taken     what `checked_nickname` takes, in NFC; empty lines are passed over, a mark of UTF-8 and ends of lines of any system too
//   refused   a name twice, however it is written; no name at all; more than a class may have
//
// Thread: any. Cost: in proportion to the text.
#pragma once

#include "haptics/base/error.h"

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// The names in a text. `where` is its file; an error names it and the line.
[[nodiscard]] Expected<std::vector<std::string>> read_name_list(std::string_view text,
                                                                const std::string& where);

/// The same for names that stand in no file.
[[nodiscard]] Expected<std::vector<std::string>> check_names(const std::vector<std::string>& names);

}  // namespace fulcrum::runtime
