// A solid of the plan that turns about an axle.
#pragma once

#include "haptics/dynamics/axle.h"

#include <cstddef>

namespace fulcrum {

/// Least inertia of a body that a hand turns, in parts of the square of the largest distance at which it may press: what
/// hangs on the hand's spring there is then no lighter than this many kilograms. A lighter one would be shaken by the
/// coupling's damper, whose velocity is known late.
inline constexpr double kLeastRimMass_kg = 0.1;

struct AxlePlan {
    std::size_t solid = 0;  ///< index in HapticPlan::solids
    AxleSettings axle{};
    double reach_m = 0.0;  ///< largest distance from the axis at which it can be touched
};

}  // namespace fulcrum
