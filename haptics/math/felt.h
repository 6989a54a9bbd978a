// What counts as felt: below it nobody in a lesson would notice a force, and nobody is harmed by one.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

inline constexpr double kLeastFelt_N = 0.05;
inline constexpr double kLeastFelt_Nm = 0.005;

[[nodiscard]] inline bool is_felt(const Wrench& wrench) noexcept {
    return wrench.force.squaredNorm() > kLeastFelt_N * kLeastFelt_N ||
           wrench.torque.squaredNorm() > kLeastFelt_Nm * kLeastFelt_Nm;
}

}  // namespace fulcrum
