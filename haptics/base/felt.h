// What counts as felt: below it nobody in a lesson would notice a force, and nobody is harmed by one.
#pragma once

namespace fulcrum {

inline constexpr double kLeastFelt_N = 0.05;
inline constexpr double kLeastFelt_Nm = 0.005;

}  // namespace fulcrum
