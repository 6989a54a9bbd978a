// What a plan's surfaces have besides their coupling; only what they ask for is there.
//
// Thread: haptic loop.
#pragma once

#include "haptics/handover/touch_sample.h"
#include "haptics/loop/texture_stage.h"
#include "haptics/loop/touch_motion.h"
#include "haptics/loop/touch_teller.h"
#include "haptics/loop/transient_stage.h"

#include <memory>
#include <span>

namespace fulcrum {

/// What the loop knows at the beginning of a round.
struct SurfaceRound {
    Vector3 hand_W{Vector3::Zero()};
    Vector3 proxy_W{Vector3::Zero()};
    Vector3 velocity_W{Vector3::Zero()};  ///< of the hand
    double dt_s = 0.0;
};

struct SurfaceEffects {
    explicit SurfaceEffects(const HapticPlan& plan) : motion(plan) {}

    TouchMotion motion;
    std::unique_ptr<TextureStage> texture;
    std::unique_ptr<TransientStage> transient;
    std::unique_ptr<TouchTeller> teller;

    /// First in a round; what the spans name must last through it. Then each of those that are there, in this order.
    void begin_round(std::span<const TouchForce> touches, std::span<const Pose> solid_poses_W,
                     const SurfaceRound& round) noexcept;
    [[nodiscard]] SurfaceForce add_texture() noexcept;
    [[nodiscard]] SurfaceForce add_transient() noexcept;
    void tell(double now_s) noexcept;
    /// The hand has jumped.
    void forget() noexcept;

  private:
    std::span<const TouchForce> touches_{};
    std::span<const Pose> poses_W_{};
    double dt_s_ = 0.0;
    bool follows_ = false;  // hand_W_ is where the hand was in the last round
    Vector3 hand_W_{Vector3::Zero()};
    Vector3 moved_W_{Vector3::Zero()};
};

/// Null where no surface of the plan has any. `ring` is null where nobody listens.
[[nodiscard]] std::unique_ptr<SurfaceEffects> make_surface_effects(const HapticPlan& plan,
                                                                   const DeviceTraits& traits,
                                                                   TouchRing* ring);

}  // namespace fulcrum
