#include "haptics/loop/touch_teller.h"

#include <algorithm>

namespace fulcrum {

bool TouchTeller::is_needed(const HapticPlan& plan) noexcept {
    return std::ranges::any_of(plan.solids,
                               [](const SolidPlan& solid) { return solid.surface.audible; });
}

TouchTeller::TouchTeller(const HapticPlan& plan, TouchRing& ring) : ring_(ring) {
    for (const SolidPlan& solid : plan.solids) {
        audible_.push_back(solid.surface.audible ? 1 : 0);
    }
}

void TouchTeller::step(std::span<const TouchForce> touches, const TouchMotion& motion,
                       const TextureStage* texture, double time_s) noexcept {
    // The audible solid that is pressed most.
    const TouchForce* most = nullptr;
    for (const TouchForce& touch : touches) {
        const auto solid = static_cast<std::size_t>(touch.solid);
        const bool heard = touch.solid >= 0 && solid < audible_.size() && audible_[solid] != 0;
        if (heard && (most == nullptr || touch.depth_m > most->depth_m)) {
            most = &touch;
        }
    }
    TouchSample sample;
    sample.time_s = time_s;
    if (most != nullptr) {
        const TouchedPlace& place = motion.place(most->solid);
        const SurfaceVector uv = project_on_view(place.view, place.place_B);
        sample.solid = most->solid;
        sample.u_m = static_cast<float>(uv.u_m);
        sample.v_m = static_cast<float>(uv.v_m);
        sample.normal_force_N = static_cast<float>(most->stiffness_N_per_m * most->depth_m);
        sample.slip_speed_m_per_s = static_cast<float>(place.slip_m_per_s);
        sample.texture_height_m =
            texture != nullptr ? static_cast<float>(texture->height_m(most->solid)) : 0.0F;
        if (motion.tap().solid == most->solid) {
            sample.impact_speed_m_per_s = static_cast<float>(motion.tap().speed_m_per_s);
        }
    }
    if (most != nullptr || told_) {
        (void)ring_.push(sample);
    }
    told_ = most != nullptr;
}

}  // namespace fulcrum
