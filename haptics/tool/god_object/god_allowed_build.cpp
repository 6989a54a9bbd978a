// The load path of god_allowed.h.
#include "haptics/tool/god_object/god_allowed.h"

namespace fulcrum {
namespace {

std::size_t find_capacity(const std::vector<GodObjectPlan>& plans,
                          const GodObjectSettings& settings, std::size_t n_recalled) {
    return plans.size() * static_cast<std::size_t>(settings.most_contacts) + n_recalled;
}

}  // namespace

GodAllowed::GodAllowed(const std::vector<GodObjectPlan>& plans, const GodObjectSettings& settings)
    : inertia_(settings.inertia),
      gap_m_(settings.gap_m),
      has_friction_(has_friction(plans)),
      solver_(has_friction_ ? 0 : find_capacity(plans, settings, kMostRecalled)),
      dragging_(has_friction_ ? find_capacity(plans, settings, kMostRecalled) : 0) {}

}  // namespace fulcrum
