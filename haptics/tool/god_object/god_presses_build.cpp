// The load path of god_presses.h.
#include "haptics/tool/god_object/god_presses.h"

namespace fulcrum {

GodPresses::GodPresses(const std::vector<GodObjectPlan>& plans, double gap_m) : gap_m_(gap_m) {
    if (!has_shading(plans)) {
        return;
    }
    shadings_.reserve(plans.size());
    for (const GodObjectPlan& plan : plans) {
        shadings_.push_back({plan.object_shading, plan.tool_shading});
    }
}

}  // namespace fulcrum
