// The motion of a tool and an object in one step, as the object sees it, and how it is cut short where something is in the way.
//
// Thread: that of the step. Cost: 0.1 us; no allocation.
#pragma once

#include "haptics/coupling/tool_coupling.h"
#include "haptics/dynamics/rigid_state.h"

namespace fulcrum {

/// Where the object of a step is at its end, and where it and the tool were at its start.
struct ToolMotion {
    Pose before_W;  ///< of the tool
    Pose object_before_W;
    MovingFrame object{};
};

/// The tool's way in the object's frame, along which it shifts and turns evenly.
struct ToolWay {
    Pose from_OT;
    Pose to_OT;
    double longest_m = 0.0;  ///< of the way of a point, at most
};

/// Where a share, 0 to 1, of a motion leads: straight for the origin, about one axis.
[[nodiscard]] Pose compute_between(const Pose& from, const Pose& to, double share) noexcept;

/// `reach_m`: how far a point lies from the tool's frame at most.
[[nodiscard]] ToolWay find_way(const ToolMotion& motion, const Pose& end_W,
                               double reach_m) noexcept;

/// Puts `end` back to a share of the way, 0 to 1, with the share `kept` of its velocity relative to the object.
void put_back(const ToolMotion& motion, const ToolWay& way, double share, double kept,
              RigidState& end) noexcept;

}  // namespace fulcrum
