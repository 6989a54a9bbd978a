// The relief of an object's material, as a god-object's tool feels it that touches it in many places. The hand feels it alone: the tool goes the same
// way to the bit.
//
//   T = K sum of (p_k / d K) o_k,   d = (sum of p_k) / K      o_k: what the relief adds at contact k, pressed d deep (texture.h, triplanar.h), p_k: its share
//                                                             of what presses the object (even_pressure.h), K: the coupling's stiffness
// so one contact feels what a point does, and many the mean of what they meet, each where it is: the source's, weighed by what presses there. Between
// two rounds of the step what T may change by, is
//   A dt / fade + (R + A / reach) (way of the tool over the object) + what the pressure changes of it
//   A: the most that T may be under this pressure      R: the most that it may change by along a metre, twice what the relief's samples show
// which leaves alone what the relief does as it passes, and gives what a contact changes by coming or going the time that a new set of contacts has
// (god_force.h). Nothing is left of T where nothing presses.
//
// Thread: haptic loop. Cost: 60 ns a contact up to what texture.h says where the tool is fast; no allocation after it was built.
// Source: M. Ortega, S. Redon, S. Coquillart 2007, A six degree-of-freedom god-object method for haptic display of rigid bodies with surface
// properties, IEEE TVCG 13(3), section 6 and figure 9: the mean of what the contacts' places perturb the force by. The weights and the bound are ours.
#pragma once

#include "haptics/math/spatial.h"
#include "haptics/math/wrench_jacobian.h"
#include "haptics/surface/texture.h"

#include <cstddef>
#include <memory>

namespace fulcrum {

/// What a relief may do, by its samples.
struct ReliefSteepness {
    double slope = 0.0;            ///< at most
    double curvature_per_m = 0.0;  ///< likewise: of the slope, a metre
};
/// Of the finest level. Cost: four samples of it each.
[[nodiscard]] ReliefSteepness find_steepness(const TextureMap& map);

/// Fixed at load.
struct GodTextureSettings {
    double stiffness_N_per_m = 500.0;  ///< K
    double reach_m = 0.1;              ///< of the tool from its centre of mass
    double fade_s = 0.03;              ///< of a new set of contacts; 0: felt at once
};

class GodTexture {
  public:
    GodTexture(std::shared_ptr<const Texture> texture, const GodTextureSettings& settings);

    /// The tool is elsewhere: nothing is felt.
    void forget() noexcept;
    /// A step has led the tool from here to there; the places that are added next are pressed with `force_N` in all.
    void begin(const Pose& from_OT, const Pose& to_OT, double force_N) noexcept;
    /// A contact that bears `force_N` of it; the normal of length 1, away from the object. What is no number adds nothing.
    void add(const Vector3& place_O, const Vector3& normal_O, double force_N) noexcept;
    /// On the tool, N and N m about its centre of mass, in the object's frame.
    const Wrench& finish(double dt_s) noexcept;

    /// What one bump holds under the present pressure, joules (energy_loan.h).
    [[nodiscard]] double bumps_J() const noexcept {
        return settings_.stiffness_N_per_m * texture_->bump_m2(depth_m_);
    }
    /// With the texture, which many may share.
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return sizeof(*this) + texture_->memory_bytes();
    }

  private:
    // Of what the texture may do under a pressure.
    struct Bounds {
        double most_m = 0.0;    // of the offset
        double per_m = 0.0;     // that it changes by along the surface
        double per_deep = 0.0;  // and with the depth
    };
    [[nodiscard]] Bounds find_bounds() const noexcept;

    std::shared_ptr<const Texture> texture_;
    GodTextureSettings settings_;
    ReliefSteepness steepness_;
    bool touched_ = false;  // in the step before
    Vector3 centre_O_{Vector3::Zero()};
    Vector6 way_O_{Vector6::Zero()};     // of this step
    Vector6 stroke_O_{Vector6::Zero()};  // evened out
    double depth_m_ = 0.0;
    double depth_before_m_ = 0.0;
    Wrench sum_O_{};
    Wrench felt_O_{};
};

}  // namespace fulcrum
