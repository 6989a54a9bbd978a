// The load path of surface_effects.h.
#include "haptics/loop/surface_effects.h"

namespace fulcrum {

std::unique_ptr<SurfaceEffects> make_surface_effects(const HapticPlan& plan,
                                                     const DeviceTraits& traits, TouchRing* ring) {
    if (!TouchMotion::is_needed(plan)) {
        return nullptr;
    }
    auto effects = std::make_unique<SurfaceEffects>(plan);
    if (TextureStage::is_needed(plan)) {
        effects->texture = std::make_unique<TextureStage>(plan);
    }
    if (TransientStage::is_needed(plan)) {
        effects->transient = std::make_unique<TransientStage>(plan, traits);
    }
    if (ring != nullptr && TouchTeller::is_needed(plan)) {
        effects->teller = std::make_unique<TouchTeller>(plan, *ring);
    }
    return effects;
}

}  // namespace fulcrum
