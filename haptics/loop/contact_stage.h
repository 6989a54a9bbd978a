// The coupling between proxy and hand, for each touched solid its own, and the direction that shading gives it.
//
//   F_spring = sum over the touches of w_i f_i(|s|) s/|s|,   w_i = push_i / sum push     s: from hand to proxy
//   F = F_spring + what each touch's damper adds (contact_damper.h)
// So the spring's force is continuous when one solid takes over from another. Where a touched mesh is shaded (shading.h) the force keeps
// its size and takes the direction of sum(push_i n_i + drag_i) with the shaded normals n_i, each drag turned as its normal is, so that
// friction stays in its cone. Friction was solved on the face that the proxy came from: what of a drag points out of the face where it came to
// lie belongs to the push there, and the rest is shortened to that push's circle.
// A shaded force is no gradient: who presses deeper on one half of a face than on the other may go round for ever and be given work.
// So only F_spring counts as ideal, and what shading turns of it and friction eases of it (contact_damper.h) is lent
// (surface/energy_loan.h): |F_spring| times what a face's lean can do (shading.h), along the hand's way against the solid.
// Where the proxy slips, over an edge or against friction, the spring lets go of energy that nobody gets:
//   paid_n = U_(n-1) - U_n - (F_(n-1) + F_n)/2 . d_n      U: the spring's energy, d: the hand's way; exact while the proxy's planes stay
// The hand has given it, so that much of what is lent is paid back in that round. Summed up the hand has had no more than U_0 - U_n and what is lent:
// whatever slips, a closed path gives it no more than before. Without it a deep push on a fine mesh would be braked for not falling off each edge:
// F s^2 depth / 2 R^2 of each face of size s. Where paid_n is below 0 the next ones make that up first. Counted only while nothing but the one
// solid is touched, and not of a cursor that turns with the hand: its turns raise U, which is lent elsewhere (point/virtual_proxy.h).
//
// Thread: haptic loop. Cost: that of the coupling; a shaded touch 20 ns more. No allocation in `step`.
#pragma once

#include "haptics/coupling/passivity.h"
#include "haptics/loop/contact_damper.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/math/spatial.h"
#include "haptics/point/proxy.h"
#include "haptics/surface/energy_loan.h"
#include "haptics/surface/shading.h"

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

/// One touch as the surface's effects see it.
struct TouchForce {
    std::int32_t solid = kNoBody;
    Vector3 normal_W{
        Vector3::UnitY()};  ///< unit, away from the surface, shaded where that was asked for
    double depth_m = 0.0;   ///< how far the surface holds the proxy off the hand along its normal
    double stiffness_N_per_m = 0.0;  ///< force over stretch of the coupling, now
};

/// What the coupling gives in one round.
struct ContactForce {
    Vector3 force_W{Vector3::Zero()};
    ContactSpring spring{};
    ElasticForce counted{};  ///< what of it gives back the hand's work
};

class ContactStage {
  public:
    /// Takes a plan that `validate` accepted, and makes the normals of the meshes that are to be shaded.
    explicit ContactStage(const HapticPlan& plan);

    /// The force on the hand. `contact` touches something; `velocities_W`, one a touch and one at least, are the hand's against the
    /// touched solids. A solid that is not in the plan has the plan's own coupling.
    [[nodiscard]] ContactForce step(const ProxyContact& contact, const Vector3& hand_W,
                                    std::span<const Vector3> velocities_W,
                                    std::span<const Pose> solid_poses_W) noexcept;
    /// Nothing is touched in this round, or the hand has jumped.
    void leave() noexcept;
    /// The touches of the last step.
    [[nodiscard]] std::span<const TouchForce> touches() const noexcept {
        return {touches_.data(), n_touches_};
    }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    // The spring as the facets have it.
    struct PlainSpring {
        Vector3 force_W{Vector3::Zero()};
        double energy_J = 0.0;
    };
    void take_touches(const ProxyContact& contact, std::span<const Vector3> velocities_W,
                      double stretch_m) noexcept;
    [[nodiscard]] ContactDamping damp(double N_per_m) noexcept;
    [[nodiscard]] bool shade(const ProxyContact& contact,
                             std::span<const Pose> solid_poses_W) noexcept;
    [[nodiscard]] ElasticForce count(const PlainSpring& plain, const Vector3& lent_W,
                                     const Vector3& hand_W,
                                     std::span<const Pose> solid_poses_W) noexcept;
    [[nodiscard]] bool touches_only(std::int32_t solid) const noexcept;
    [[nodiscard]] std::int32_t find_shaded() const noexcept;
    [[nodiscard]] const CouplingSettings& coupling_of(std::int32_t solid) const noexcept;

    CouplingSettings common_;
    std::vector<CouplingSettings> couplings_;                    // one a solid
    std::vector<std::unique_ptr<const ShadedNormals>> shading_;  // empty where no solid is shaded
    std::array<TouchForce, kMaxTouches> touches_{};
    std::array<DampedPlane, kMaxTouches> planes_{};  // of the touches
    std::size_t n_touches_ = 0;
    EnergyLoan loan_;  // of shading
    double period_s_;  // of the loop
    bool pays_slips_;  // a cursor that turns moves the proxy by what is no work of the hand's
    // In the round before.
    std::int32_t lender_ = kNoBody;  // the solid that was lent of
    Vector3 hand_W_{Vector3::Zero()};
    Vector3 hand_B_{Vector3::Zero()};  // in the lender's frame
    bool only_lender_ = false;         // nothing else was touched
    double unpaid_J_ = 0.0;            // that the spring gained beyond the hand's work
    PlainSpring plain_{};
};

}  // namespace fulcrum
