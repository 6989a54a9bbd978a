#include "haptics/loop/touch_stage.h"

namespace fulcrum {

void TouchStage::put(std::uint32_t solids, std::span<const Pose> solid_poses_W) noexcept {
    velocity_.put(solids, solid_poses_W);
    for (std::size_t i = 0; i < solid_poses_W.size(); ++i) {
        if ((solids >> i & 1U) != 0) {
            proxy_->put_solid(i, solid_poses_W[i]);
        }
    }
}

Quaternion TouchStage::move(const Pose& hand_W, std::span<const Pose> solid_poses_W) noexcept {
    const Quaternion turn_W = proxy_->turn(hand_W.orientation);
    contact_ = proxy_->step(hand_W.position, solid_poses_W);
    return turn_W;
}

ContactForce TouchStage::couple(const Vector3& hand_W, const TouchVelocity::Hand& hand,
                                std::span<const Pose> solid_poses_W) noexcept {
    if (contact_.solid < 0) {
        coupling_.leave();
        velocity_.leave();
        return {};
    }
    return coupling_.step(contact_, hand_W, velocity_.step(contact_, solid_poses_W, hand),
                          solid_poses_W);
}

void TouchStage::forget(const Vector3& hand_W) noexcept {
    proxy_->reset(hand_W);
    coupling_.leave();
    velocity_.forget();
    if (effects_) {
        effects_->forget();
    }
}

}  // namespace fulcrum
