// The load path of contact_stage.h.
#include "haptics/loop/contact_stage.h"

#include <algorithm>

namespace fulcrum {

ContactStage::ContactStage(const HapticPlan& plan)
    : common_(plan.coupling),
      loan_(plan.shading_loan),
      period_s_(1.0 / plan.rate_hz),
      pays_slips_(is_round(plan.proxy.cursor)) {
    couplings_.reserve(plan.solids.size());
    for (const SolidPlan& solid : plan.solids) {
        couplings_.push_back(solid.coupling.value_or(plan.coupling));
    }
    const auto is_shaded = [](const SolidPlan& solid) {
        const MeshShape* mesh = find_mesh(solid.shape);
        return solid.surface.shading.on && mesh != nullptr && *mesh;
    };
    if (!std::ranges::any_of(plan.solids, is_shaded)) {
        return;
    }
    shading_.resize(plan.solids.size());
    for (std::size_t i = 0; i < plan.solids.size(); ++i) {
        const SolidPlan& solid = plan.solids[i];
        if (is_shaded(solid)) {
            shading_[i] = std::make_unique<const ShadedNormals>(
                *find_mesh(solid.shape), solid.surface.shading.crease_angle_deg);
        }
    }
}

std::size_t ContactStage::memory_bytes() const noexcept {
    std::size_t bytes = sizeof(ContactStage) + couplings_.capacity() * sizeof(CouplingSettings) +
                        shading_.capacity() * sizeof(shading_[0]);
    for (const auto& one : shading_) {
        bytes += one ? sizeof(ShadedNormals) + one->memory_bytes() : 0;
    }
    return bytes;
}

}  // namespace fulcrum
