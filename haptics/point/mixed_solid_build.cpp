// The load path of mixed_solid.h.
#include "haptics/point/make_obstacle.h"
#include "haptics/point/mixed_solid.h"

namespace fulcrum {

MixedSolid::MixedSolid(const SolidPlan& plan, std::int32_t index, SegmentStructureKind structure)
    : solid_(find_mesh(plan.shape) != nullptr
                 ? std::variant<MovingSolid, MovingObstacle>(MovingSolid(plan, index, structure))
                 : make_moving_obstacle(CursorShape(), plan, index)) {}

}  // namespace fulcrum
