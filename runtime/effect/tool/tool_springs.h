// Whether a tool's mass and springs can be computed in the hand that the lesson has, told in the lesson's own words before anything
// that takes long is made.
//
// Thread: load path. Cost: nothing.
#pragma once

#include "haptics/tool/tool_plan.h"
#include "runtime/scene/description.h"

namespace fulcrum::runtime {

/// Refuses with one sentence and the line of the lesson. `reach_m` is how far the tool's farthest point lies from its middle.
[[nodiscard]] Expected<void> check_tool_springs(const HandDescription& hand, const ToolOrder& order,
                                                double reach_m);

}  // namespace fulcrum::runtime
