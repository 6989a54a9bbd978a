// Where a simulated person wants the hand to be.
#pragma once

#include "haptics/math/spatial.h"

#include <cmath>
#include <cstdint>

namespace fulcrum {

/// Where the simulated person wants the hand to be, in the device's frame. Newest value; whoever
/// plays the person writes.
struct HandTarget {
    Pose pose_D{};                        ///< metres
    Vector3 velocity_D{Vector3::Zero()};  ///< metres per second; with it the hand follows a moving
                                          ///< target without lag
    std::uint32_t buttons = 0;            ///< one bit a button
    bool sees_thing = false;              ///< there is something to touch
    Vector3 thing_D{Vector3::Zero()};     ///< the middle of the nearest such thing
};

/// A target that is no pose would stay in an arm's state for ever.
[[nodiscard]] inline bool is_usable(const HandTarget& target) noexcept {
    constexpr double kUnitTolerance = 1.0e-3;
    return is_finite(target.pose_D) && is_finite(target.velocity_D) &&
           std::abs(target.pose_D.orientation.coeffs().norm() - 1.0) < kUnitTolerance;
}

}  // namespace fulcrum
