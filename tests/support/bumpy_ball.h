// The ball that make_bumpy_sphere approaches, for tests that press it: bumps of 3 % of its radius, twenty radians of them a radius.
#pragma once

#include "haptics/math/spatial.h"

#include <cmath>

namespace fulcrum {

inline constexpr double kBumpHeight = 0.03;
inline constexpr double kBumps = 20.0;

/// Its radius along a unit vector, of the mean radius.
inline double bumpy_radius(const Vector3& u) {
    return 1.0 +
           kBumpHeight *
               (std::sin(kBumps * u.x()) + std::sin(kBumps * u.y()) + std::sin(kBumps * u.z())) /
               3.0;
}

}  // namespace fulcrum
