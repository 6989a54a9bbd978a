// The load path of god_pairs.h.
#include "haptics/tool/god_object/god_pairs.h"

namespace fulcrum {

GodPairs::GodPairs(const std::vector<GodObjectPlan>& plans, const GodObjectSettings& settings)
    : gap_m_(settings.gap_m),
      reach_m_(find_reach_m(plans)),
      objects_W_(plans.size()),
      goals_W_(plans.size()) {
    pairs_.reserve(plans.size());
    for (const GodObjectPlan& plan : plans) {
        pairs_.emplace_back(plan.object, plan.tool, settings.most_contacts);
    }
}

std::size_t GodPairs::memory_bytes() const noexcept {
    std::size_t bytes = 2 * objects_W_.capacity() * sizeof(Pose);
    for (const GodPair& pair : pairs_) {
        bytes += sizeof(GodPair) + pair.memory_bytes() + pair.object().memory_bytes();
    }
    return bytes + (pairs_.empty() ? 0 : pairs_.front().tool().memory_bytes());
}

}  // namespace fulcrum
