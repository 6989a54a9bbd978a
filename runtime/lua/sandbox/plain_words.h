// What Lua itself says of a mistake, followed by what to do, for a teacher who has never heard of <eof>.
//
// Thread: pure. Cost: a few searches in one sentence; only when something failed.
#pragma once

#include <string>

namespace fulcrum::runtime {

/// Lua's `message` without its place, with advice behind it where there is some: "'}' expected near 'visible'; put a comma
/// between two fields".
[[nodiscard]] std::string in_plain_words(std::string message);

}  // namespace fulcrum::runtime
