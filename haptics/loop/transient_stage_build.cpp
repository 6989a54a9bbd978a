// The load path of transient_stage.h.
#include "haptics/device/simulated/human_impedance.h"
#include "haptics/loop/transient_stage.h"

#include <algorithm>

namespace fulcrum {

HandleModel make_handle_model(const HapticPlan& plan, const DeviceTraits& traits) {
    const double mass_kg = traits.mass_kg > 0.0 ? traits.mass_kg : plan.passivity.handle_mass_kg;
    return {mass_kg + kFingertip.mass_kg, traits.damping_Ns_per_m + kFingertip.damping_Ns_per_m,
            kFingertip.stiffness_N_per_m};
}

bool TransientStage::is_needed(const HapticPlan& plan) noexcept {
    return std::ranges::any_of(
        plan.solids, [](const SolidPlan& solid) { return solid.surface.transient.any(); });
}

TransientStage::TransientStage(const HapticPlan& plan, const DeviceTraits& traits)
    : handle_(make_handle_model(plan, traits)), scale_(plan.workspace.scale) {
    settings_.reserve(plan.solids.size());
    for (const SolidPlan& solid : plan.solids) {
        settings_.push_back(solid.surface.transient);
    }
}

}  // namespace fulcrum
