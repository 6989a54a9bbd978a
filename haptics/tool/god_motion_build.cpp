// The load path of god_motion.h.
#include "haptics/tool/god_motion.h"

#include <algorithm>

namespace fulcrum {
namespace {

std::size_t find_capacity(const std::vector<GodObjectPlan>& plans,
                          const GodObjectSettings& settings, std::size_t n_recalled) {
    return plans.size() * static_cast<std::size_t>(settings.most_contacts) + n_recalled;
}

}  // namespace

GodMotion::GodMotion(const std::vector<GodObjectPlan>& plans, const GodObjectSettings& settings,
                     GodChannels* channels)
    : settings_(settings),
      channels_(channels),
      objects_W_(plans.size()),
      goals_W_(plans.size()),
      has_friction_(has_friction(plans)),
      is_followed_(has_friction_ || has_texture(plans)),
      slips_(plans.size()),
      solver_(has_friction_ ? 0 : find_capacity(plans, settings, kMostRecalled)),
      dragging_(has_friction_ ? find_capacity(plans, settings, kMostRecalled) : 0),
      reach_m_(find_reach_m(plans)) {
    if (channels_ != nullptr) {
        told_.emplace(channels_->set);
    }
    pairs_.reserve(plans.size());
    frictions_.reserve(plans.size());
    const bool is_shaded = has_shading(plans);
    for (const GodObjectPlan& plan : plans) {
        if (is_shaded) {
            shadings_.push_back({plan.object_shading, plan.tool_shading});
        }
        frictions_.push_back(plan.friction);
        pairs_.emplace_back(plan.object, plan.tool, settings.most_contacts);
    }
}

GodMotion::~GodMotion() = default;

std::size_t GodMotion::memory_bytes() const noexcept {
    constexpr std::size_t kPerRow = sizeof(Vector6) + 2 * sizeof(double);
    std::size_t bytes = sizeof(*this) + 2 * objects_W_.capacity() * sizeof(Pose) +
                        slips_.capacity() * sizeof(Slip) +
                        frictions_.capacity() * sizeof(FrictionSettings) + dragging_.memory_bytes();
    for (const GodPair& pair : pairs_) {
        bytes += sizeof(GodPair) + pair.memory_bytes() + pair.object().memory_bytes() +
                 (has_friction_ ? 0 : static_cast<std::size_t>(settings_.most_contacts) * kPerRow);
    }
    return bytes + (pairs_.empty() ? 0 : pairs_.front().tool().memory_bytes());
}

}  // namespace fulcrum
