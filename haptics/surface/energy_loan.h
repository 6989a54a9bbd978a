// How much energy a surface's texture, or the ringing of a tap, may have given the hand more than it took.
//
// The passivity stage compares what the hand was given with what the ideal scene gives (passivity.h). A texture's bumps are a part
// of that scene, and so is a tap's ringing: a brake on every sampled bump would wipe them out. But a law that is no gradient,
// or a relief steeper than the loop can follow, could feed a buzz for ever if it were taken for elastic. So both get a loan:
//   a <- max(a + T . d, -limit)      T: the force held over the period, d: the hand's way in it; a: what is owed
//   x  = max(a - limit, 0),  a <- a - x
// T . d - x counts as ideal, x does not: the brake sees it. Bumps that give back what they took owe between - limit and
// limit for ever, and are never braked; what they give for good they can give only once. The force is not changed here.
// limit: of a texture K k d H, what one bump of height H holds under the present pressure (falling to it within kLoanMemory_s where
// the hand lifts); of a tap the stated share of m v^2 / 2.
//
// In terms of passivity.h: S = T and H = T - 2 x d / |d|^2, so that (S + H)/2 . d = T . d - x.
// Thread: haptic loop. Cost: about 5 ns. Source: ours; the idea of a bounded tank is that of S. Stramigioli and C. Secchi
// (energy tanks), here without the port's dynamics.
#pragma once

#include "haptics/coupling/elastic_force.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

inline constexpr double kLoanMemory_s = 1.0;

class EnergyLoan {
  public:
    /// The limit is at least `limit_J` now; a higher one from before falls towards it in `dt_s`. Not finite or negative: 0.
    void allow(double limit_J, double dt_s) noexcept;
    /// Nothing is owed and nothing allowed, as when the surface is left.
    void settle() noexcept;

    /// Counts the period that has just ended with the hand `motion_W` further, and takes over the force of the next.
    [[nodiscard]] ElasticForce step(const Vector3& next_W, const Vector3& motion_W) noexcept;

    [[nodiscard]] double owed_J() const noexcept { return owed_J_; }
    [[nodiscard]] double limit_J() const noexcept { return limit_J_; }

  private:
    double limit_J_ = 0.0;
    double owed_J_ = 0.0;
    Vector3 force_W_{Vector3::Zero()};
};

}  // namespace fulcrum
