// The checker of free English for a lesson that calls for it: word lists, grammar and rules, opened together.
//
// Thread: one.  Cost: about 0.25 s and 16 MB to open; then up to some ten milliseconds an answer.
#pragma once

#include "dialogue/conversation/conversation.h"
#include "haptics/base/error.h"

namespace fulcrum::runtime {

/// Opens it; an error names the Debian package that is missing.
[[nodiscard]] Expected<dialogue::FormCheck> open_free_english();

}  // namespace fulcrum::runtime
