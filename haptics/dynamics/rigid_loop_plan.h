// What the loop of a world of rigid bodies is made from.
#pragma once

#include "haptics/base/error.h"
#include "haptics/dynamics/rigid_world_plan.h"
#include "haptics/handover/messages.h"

#include <cstdint>
#include <vector>

namespace fulcrum {

struct RigidLoopPlan {
    RigidWorldPlan world{};
    double rate_hz = 1000.0;  ///< 50 to 5000
    /// The scene's index of each of the world's bodies, kNoBody of what the scene has not: as many, each index below kMaxBodies and once.
    std::vector<std::int32_t> scene_bodies;
    /// The world's body that each solid of the hands' plans is, kNoBody of others; at most kMaxSolids.
    std::vector<std::int32_t> solids;
    /// The world's body that a hand holds all the time, and in which others are caught; kNoBody: none.
    std::int32_t carrier = kNoBody;
    std::vector<std::int32_t> hidden;  ///< bodies of the world that are not there at the start
};

/// Refuses what `validate` of the world does, a rate out of range, and lists that do not fit.
[[nodiscard]] Expected<void> validate(const RigidLoopPlan& plan);

}  // namespace fulcrum
