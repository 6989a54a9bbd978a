// The transient stage of the haptic loop: a solid that is tapped answers with its ringing, as long as it is touched.
//
//   F = F_transient(t) N         N: the solid's normal where it is touched now; nothing in free space
// One rings at a time; a new tap takes over. The passivity stage counts it as ideal until it has given back energy_share of
// the tap's m v^2 / 2 (energy_loan.h); m: the handle that the transient is made for.
//
// Thread: haptic loop. Cost: about 50 ns while it rings, 5 ns else. No allocation in `step`.
#pragma once

#include "haptics/device/device.h"
#include "haptics/loop/contact_stage.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/loop/texture_stage.h"
#include "haptics/loop/touch_motion.h"
#include "haptics/surface/energy_loan.h"
#include "haptics/surface/transient.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fulcrum {

/// The device's handle with the fingertips that hold it: what a transient shakes.
[[nodiscard]] HandleModel make_handle_model(const HapticPlan& plan, const DeviceTraits& traits);

class TransientStage {
  public:
    [[nodiscard]] static bool is_needed(const HapticPlan& plan) noexcept;
    /// Takes a plan that `validate` accepted.
    TransientStage(const HapticPlan& plan, const DeviceTraits& traits);

    /// After the motion was stepped. `hand_moved_W` is the hand's way since the last round.
    [[nodiscard]] SurfaceForce step(std::span<const TouchForce> touches, const Tap& tap,
                                    const Vector3& hand_moved_W, double dt_s) noexcept;
    /// The hand has jumped.
    void forget() noexcept { silence(); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return sizeof(TransientStage) + settings_.capacity() * sizeof(TransientSettings);
    }

  private:
    void silence() noexcept;

    std::vector<TransientSettings> settings_;  // one a solid
    HandleModel handle_;
    double scale_;  // world metres a metre of the hand
    std::int32_t ringing_ = kNoBody;
    Transient transient_{};
    EnergyLoan loan_{};
};

}  // namespace fulcrum
