// Where everything is that a frame shows, as the loops tell it.
#pragma once

#include "haptics/flight/kite_loop.h"
#include "haptics/handover/axle_messages.h"
#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

#include <vector>

namespace fulcrum::runtime {

/// A hand beside the first.
struct HandScenery {
    HapticState hand{};
    bool ghost = false;
    Pose ghost_pose_W{};
};

/// Everything that a frame shows.
struct Scenery {
    double time_s = 0.0;
    HapticState hand{};
    const WorldSnapshot* world = nullptr;  ///< null when the plan has none
    const AxleFrame* axles = nullptr;      ///< null when nothing turns
    const KiteFrame* kite = nullptr;       ///< null when nothing flies
    bool renders_force = true;  ///< false for a mouse: what can't be felt is shown more strongly
    bool ghost = false;         ///< show where the hand itself is
    Pose ghost_pose_W{};
    std::vector<HandScenery> more_hands{};
};

}  // namespace fulcrum::runtime
