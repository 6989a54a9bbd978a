// Where everything is that a frame shows, as the loops tell it.
#pragma once

#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"
#include "runtime/lesson/effect_messages.h"

#include <vector>

namespace fulcrum::runtime {

/// A hand beside the first.
struct HandScenery {
    HapticState hand{};
    bool ghost = false;
    Pose ghost_pose_W{};
};

/// Everything that a frame shows.
struct Scenery : EffectFrames {
    double time_s = 0.0;
    HapticState hand{};
    bool renders_force = true;  ///< false for a mouse: what can't be felt is shown more strongly
    bool ghost = false;         ///< show where the hand itself is
    Pose ghost_pose_W{};
    std::vector<HandScenery> more_hands{};
    bool calm = false;                      ///< nothing is squashed
    std::optional<Vector3> still_hand_W{};  ///< where the program's own hand is seen instead
};

}  // namespace fulcrum::runtime
