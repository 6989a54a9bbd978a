// The rounds of a loop as its tests run them.
#pragma once

namespace fulcrum {

inline constexpr double kDt_s = 0.001;
inline constexpr double kRounding = 1e-9;  // sums of a few thousand doubles near 1

}  // namespace fulcrum
