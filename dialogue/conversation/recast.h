// How the right sentence is said back.
//
// Thread: pure.  Cost: none.
#pragma once

#include "dialogue/marking/mark.h"

#include <string_view>

namespace fulcrum::dialogue {

/// A learner who asks is answered like one: nobody felt anything.
[[nodiscard]] bool asks_back(std::string_view sentence);

/// "Yes, it is heavier": said already.
[[nodiscard]] bool says_yes_or_no(const Mark& mark);

/// The catalogue's key for it.
[[nodiscard]] const char* recast_key(const Mark& mark);

}  // namespace fulcrum::dialogue
