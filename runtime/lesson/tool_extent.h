// How far the tool in the hand reaches from where it is held: so that what is drawn beside it hides nothing of it.
//
// Thread: any. Cost: a nanosecond a point, of up to 4096.
#pragma once

#include "haptics/tool/tool_plan.h"

namespace fulcrum::runtime {

/// In a direction of unit length, metres; the tool's handle is turned by `turn_W`. 0 where the plan has no points.
[[nodiscard]] double compute_tool_extent_m(const ToolPlan& plan, const Quaternion& turn_W,
                                           const Vector3& direction_W);

}  // namespace fulcrum::runtime
