// What Lua itself says of a mistake, followed by what to do, for a teacher who has never heard of <eof>.
//
// Thread: pure. Cost: a few searches in one sentence; only when something failed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// Lua's `message` without its place, with advice behind it where there is some: "'}' expected near 'visible'; put a comma
/// between two fields".
[[nodiscard]] std::string in_plain_words(std::string message);

/// A call of the lesson's that takes a table, and has no { behind it.
struct MissingBrace {
    int line = 0;
    std::string call;  ///< as it stands there: "L:question "float""
};

/// Where Lua cannot read `text` in line `line`: the nearest such call before it whose fields follow; none where all have their {.
[[nodiscard]] std::optional<MissingBrace> find_missing_brace(std::string_view text, int line);

}  // namespace fulcrum::runtime
