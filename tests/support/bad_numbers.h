// Numbers that are none, and such that are too large.
#pragma once

#include <limits>

namespace fulcrum {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace fulcrum
