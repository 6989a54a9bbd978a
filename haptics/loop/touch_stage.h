// The stage of a proxy: what touches the solids in the hand's place, and what of that the hand feels.
//
// Thread: haptic loop. Cost: that of the proxy, the coupling and the surfaces' effects; no allocation in a round.
#pragma once

#include "haptics/device/device.h"
#include "haptics/handover/touch_sample.h"
#include "haptics/loop/contact_stage.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/loop/surface_effects.h"
#include "haptics/loop/touch_velocity.h"
#include "haptics/point/proxy.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace fulcrum {

class TouchStage {
  public:
    /// Takes a plan that `validate` accepted. `ring` is null where nobody listens.
    TouchStage(const HapticPlan& plan, std::unique_ptr<Proxy> proxy, const DeviceTraits& traits,
               TouchRing* ring)
        : proxy_(std::move(proxy)),
          coupling_(plan),
          effects_(make_surface_effects(plan, traits, ring)) {}

    /// Solid i of bit i was put elsewhere at once.
    void put(std::uint32_t solids, std::span<const Pose> solid_poses_W) noexcept;
    /// The proxy follows the hand among the solids; returns how it is turned.
    Quaternion move(const Pose& hand_W, std::span<const Pose> solid_poses_W) noexcept;
    /// Nothing is touched in this round.
    void leave() noexcept { contact_ = {}; }
    /// Then the force of the coupling, none where nothing is touched.
    [[nodiscard]] ContactForce couple(const Vector3& hand_W, const TouchVelocity::Hand& hand,
                                      std::span<const Pose> solid_poses_W) noexcept;
    /// Then, where solids may be elsewhere in the next round: where they were.
    void keep(std::span<const Pose> solid_poses_W, double stamp_s) noexcept {
        velocity_.keep(solid_poses_W, stamp_s);
    }
    /// The hand has jumped to here.
    void forget(const Vector3& hand_W) noexcept;

    [[nodiscard]] const ProxyContact& contact() const noexcept { return contact_; }
    [[nodiscard]] std::span<const TouchForce> touches() const noexcept {
        return coupling_.touches();
    }
    /// Null where no surface has any.
    [[nodiscard]] SurfaceEffects* effects() const noexcept { return effects_.get(); }
    [[nodiscard]] std::size_t coupling_bytes() const noexcept { return coupling_.memory_bytes(); }

  private:
    std::unique_ptr<Proxy> proxy_;
    ContactStage coupling_;
    TouchVelocity velocity_{};
    std::unique_ptr<SurfaceEffects> effects_;
    ProxyContact contact_{};
};

}  // namespace fulcrum
