// A tool that is a shape by rule, as it is drawn: in its own size, about its middle, round about y.
//
// Thread: any. Cost: a few thousand corners.
#pragma once

#include "haptics/point/proxy_plan.h"
#include "runtime/scene/model.h"

namespace fulcrum::runtime {

/// A ball, box, capsule or cylinder in the colour of the hand; a point is a ball of 1 cm.
[[nodiscard]] LoadedModel make_tool_model(const CursorShape& shape);
/// The same in the colour of a second hand, another one to every pair of eyes.
[[nodiscard]] LoadedModel make_second_tool_model(const CursorShape& shape);

}  // namespace fulcrum::runtime
