// The texture stage of the haptic loop: what the touched solids' reliefs add to the coupling.
//
//   F = sum over the touches of k_i (offset of the relief under depth d_i)       texture.h, triplanar.h
// The passivity stage counts it as ideal as far as the bumps' loan goes (energy_loan.h).
//
// Thread: haptic loop. Cost: that of texture.h for each touch of a textured solid. No allocation in `step`.
#pragma once

#include "haptics/coupling/elastic_force.h"
#include "haptics/loop/contact_stage.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/loop/touch_motion.h"
#include "haptics/surface/energy_loan.h"
#include "haptics/surface/triplanar.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

/// A force of a surface's effect, and how much of it is the ideal scene's.
struct SurfaceForce {
    Vector3 force_W{Vector3::Zero()};
    ElasticForce counted{};
};

class TextureStage {
  public:
    [[nodiscard]] static bool is_needed(const HapticPlan& plan) noexcept;
    /// Takes a plan that `validate` accepted, and makes its textures.
    explicit TextureStage(const HapticPlan& plan);

    /// After the motion was stepped. `hand_moved_W` is the hand's way since the last round.
    [[nodiscard]] SurfaceForce step(std::span<const TouchForce> touches, const TouchMotion& motion,
                                    std::span<const Pose> solid_poses_W,
                                    const Vector3& hand_moved_W, double dt_s) noexcept;
    /// The hand has jumped.
    void forget() noexcept { loan_.settle(); }

    /// Height of a touched solid's relief as felt in the last step, 0 where it has none.
    [[nodiscard]] double height_m(std::int32_t solid) const noexcept {
        return heights_m_[static_cast<std::size_t>(solid)];
    }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    std::vector<std::shared_ptr<const Texture>> textures_;  // one a solid, empty where it has none
    std::vector<double> heights_m_;
    EnergyLoan loan_{};
};

}  // namespace fulcrum
