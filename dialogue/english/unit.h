// Units of measure, as answers name them without a number: "in newtons".
//
// Thread: pure function.  Cost: a table look-up.
#pragma once

#include <string_view>

namespace fulcrum::dialogue {

/// True for the plural of a unit in lower case, "newtons": in it something is measured, and it takes no determiner.
[[nodiscard]] bool is_unit(std::string_view plural);

}  // namespace fulcrum::dialogue
