// What steps of a tool and of the world were short of, as a person reads it: a run's last words, its record, `explain --analyze` and `soak`.
#pragma once

#include "haptics/handover/messages.h"

#include <array>

namespace fulcrum::runtime {

/// In the order of ToolLack, after "N steps of the tool".
inline constexpr std::array<const char*, kToolLacks> kToolLackWords{
    "were not settled within their rounds: the last force that was is felt",
    "were wedged: bodies that close upon it wait where they touched",
    "had more contacts than there is room for: those left out are not felt",
    "ended before their solver was within its tolerance: the best that it found is felt"};

/// After "N ".
inline constexpr const char* kUnconvergedWords =
    "steps of the world ended before its solver was within its tolerance: bodies may slide or sink "
    "in a little.";

}  // namespace fulcrum::runtime
