// A solid of the plan that is a rigid body of a world beside the haptic loop.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fulcrum {

struct RigidSolidPlan {
    std::size_t solid = 0;         ///< index in HapticPlan::solids, but of one that is held
    double mass_kg = 1.0;          ///< above 0
    double moment_kg_m2 = 1.0e-3;  ///< its greatest, above 0
    /// Buttons that grip it while the hand touches it, one bit each; 0: it is pushed alone.
    std::uint32_t grip_buttons = 0;
    /// Held by its origin all the time, turned as the hand is: the hand is in it, and touches nothing. It is no solid of the plan: its `solid` is
    /// their number, its place in the world's frame behind theirs.
    bool is_held = false;
};

}  // namespace fulcrum
