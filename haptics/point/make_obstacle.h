// From a solid of the plan to the obstacle that a cursor meets.
//
// Thread: load.
#pragma once

#include "haptics/base/error.h"
#include "haptics/collision/obstacle.h"
#include "haptics/point/moving_obstacle.h"
#include "haptics/point/proxy_plan.h"
#include "haptics/point/solid_plan.h"

#include <optional>
#include <vector>

namespace fulcrum {

/// The cursor as a body; none for a point.
[[nodiscard]] std::optional<SolidShape> to_solid_shape(const CursorShape& cursor);

/// Refuses what no obstacle is there for.
[[nodiscard]] Expected<void> validate_pair(const CursorShape& cursor, const SolidShape& shape);

/// Of a solid that is the plan's `index`th, of what `validate_pair` accepted.
[[nodiscard]] MovingObstacle make_moving_obstacle(const CursorShape& cursor, const SolidPlan& solid,
                                                  std::int32_t index);

/// One for each solid, in the plan's order.
[[nodiscard]] std::vector<MovingObstacle> make_obstacles(const CursorShape& cursor,
                                                         const std::vector<SolidPlan>& solids);

}  // namespace fulcrum
