// The load path of god_motion.h.
#include "haptics/tool/god_object/god_motion.h"

namespace fulcrum {

GodMotion::GodMotion(const std::vector<GodObjectPlan>& plans, const GodObjectSettings& settings,
                     GodChannels* channels)
    : settings_(settings),
      channels_(channels),
      pairs_(plans, settings),
      slips_(plans, settings.gap_m),
      allowed_(plans, settings),
      presses_(plans, settings.gap_m) {
    if (channels_ != nullptr) {
        told_.emplace(channels_->set);
    }
}

GodMotion::~GodMotion() = default;

std::size_t GodMotion::memory_bytes() const noexcept {
    return sizeof(*this) + pairs_.memory_bytes() + slips_.memory_bytes() + allowed_.memory_bytes() +
           presses_.memory_bytes();
}

}  // namespace fulcrum
