// The step path of surface_effects.h.
#include "haptics/loop/surface_effects.h"

namespace fulcrum {

void SurfaceEffects::begin_round(std::span<const TouchForce> touches,
                                 std::span<const Pose> solid_poses_W,
                                 const SurfaceRound& round) noexcept {
    touches_ = touches;
    poses_W_ = solid_poses_W;
    dt_s_ = round.dt_s;
    moved_W_ = follows_ ? Vector3(round.hand_W - hand_W_) : Vector3(Vector3::Zero());
    hand_W_ = round.hand_W;
    follows_ = true;
    motion.step(touches, solid_poses_W, {round.proxy_W, round.velocity_W, round.dt_s});
}

SurfaceForce SurfaceEffects::add_texture() noexcept {
    return texture->step(touches_, motion, poses_W_, moved_W_, dt_s_);
}

SurfaceForce SurfaceEffects::add_transient() noexcept {
    return transient->step(touches_, motion.tap(), moved_W_, dt_s_);
}

void SurfaceEffects::tell(double now_s) noexcept {
    teller->step(touches_, motion, texture.get(), now_s);
}

void SurfaceEffects::forget() noexcept {
    follows_ = false;
    motion.forget();
    if (texture) {
        texture->forget();
    }
    if (transient) {
        transient->forget();
    }
}

}  // namespace fulcrum
