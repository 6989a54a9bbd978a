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

/// One for each solid, in the plan's order, of what `validate_pair` accepted.
[[nodiscard]] std::vector<MovingObstacle> make_obstacles(const CursorShape& cursor,
                                                         const std::vector<SolidPlan>& solids);

}  // namespace fulcrum
