// The step path of texture_stage.h.
#include "haptics/loop/texture_stage.h"

#include <algorithm>

namespace fulcrum {

SurfaceForce TextureStage::step(std::span<const TouchForce> touches, const TouchMotion& motion,
                                std::span<const Pose> solid_poses_W, const Vector3& hand_moved_W,
                                double dt_s) noexcept {
    SurfaceForce felt;
    double bumps_J = 0.0;
    std::ranges::fill(heights_m_, 0.0);
    for (const TouchForce& touch : touches) {
        const auto solid = static_cast<std::size_t>(touch.solid);
        if (touch.solid < 0 || solid >= std::min(textures_.size(), solid_poses_W.size()) ||
            !textures_[solid]) {
            continue;
        }
        const Texture& texture = *textures_[solid];
        const TouchedPlace& place = motion.place(touch.solid);
        const Quaternion& turn_WB = solid_poses_W[solid].orientation;
        const BodyOffset offset = feel_on_body(texture, place.place_B, place.stroke_B,
                                               turn_WB.conjugate() * touch.normal_W, touch.depth_m);
        felt.force_W += touch.stiffness_N_per_m * (turn_WB * offset.offset_B_m);
        heights_m_[solid] = offset.height_m;
        bumps_J += touch.stiffness_N_per_m * texture.bump_m2(touch.depth_m);
    }
    if (touches.empty()) {
        loan_.leave(dt_s);
        return felt;
    }
    loan_.allow(bumps_J, dt_s);
    felt.counted = loan_.step(felt.force_W, hand_moved_W);
    return felt;
}

}  // namespace fulcrum
