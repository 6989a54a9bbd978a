// The step path of transient_stage.h.
#include "haptics/loop/transient_stage.h"

#include <algorithm>

namespace fulcrum {

void TransientStage::silence() noexcept {
    transient_.stop();
    loan_.settle();
    ringing_ = kNoBody;
}

SurfaceForce TransientStage::step(std::span<const TouchForce> touches, const Tap& tap,
                                  const Vector3& hand_moved_W, double dt_s) noexcept {
    if (tap.solid >= 0 && settings_[static_cast<std::size_t>(tap.solid)].any()) {
        const TransientSettings& settings = settings_[static_cast<std::size_t>(tap.solid)];
        silence();
        ringing_ = tap.solid;
        // The hand moves in its own metres, and so does what it is shaken by.
        const double speed_m_per_s = tap.speed_m_per_s / scale_;
        transient_.start(settings, handle_, speed_m_per_s);
        // Joules of newtons and the world's metres, as all that is counted here.
        loan_.allow(
            settings.energy_share * 0.5 * handle_.mass_kg * speed_m_per_s * speed_m_per_s * scale_,
            0.0);
    }
    const auto touch = std::ranges::find(touches, ringing_, &TouchForce::solid);
    if (ringing_ == kNoBody || touch == touches.end() || !transient_.rings()) {
        silence();
        return {};
    }
    SurfaceForce felt;
    felt.force_W = transient_.step(dt_s) * touch->normal_W;
    felt.counted = loan_.step(felt.force_W, hand_moved_W);
    return felt;
}

}  // namespace fulcrum
