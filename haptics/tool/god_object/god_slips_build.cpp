// The load path of god_slips.h.
#include "haptics/tool/god_object/god_slips.h"

namespace fulcrum {

GodSlips::GodSlips(const std::vector<GodObjectPlan>& plans, double gap_m)
    : gap_m_(gap_m), is_followed_(has_friction(plans) || has_texture(plans)), slips_(plans.size()) {
    frictions_.reserve(plans.size());
    for (const GodObjectPlan& plan : plans) {
        frictions_.push_back(plan.friction);
    }
}

}  // namespace fulcrum
