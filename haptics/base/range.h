// Numbers of a plan or a setting that must lie between two bounds, and the sentence for one that does not.
//
// Thread: load path. Cost: a comparison a number.
#pragma once

#include "haptics/base/error.h"

#include <span>
#include <string>
#include <string_view>

namespace fulcrum {

/// A number and where it may lie, bounds included.
struct Range {
    std::string name;  ///< as it is called where it was given, with its unit
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// Refuses the first number that lies outside its bounds, NaN included: "`whose` `name` is `value`,
/// outside the range `low` to `high`; set it within that range".
[[nodiscard]] Expected<void> check_ranges(std::string_view whose, std::span<const Range> ranges);

}  // namespace fulcrum
