// How much energy a surface's texture, or the ringing of a tap, may have given the hand more than it took.
//
// The passivity stage compares what the hand was given with what the ideal scene gives (passivity.h). A texture's bumps are a part
// of that scene, and so is a tap's ringing: a brake on every sampled bump would wipe them out. But a law that is no gradient,
// or a relief steeper than the loop can follow, could feed a buzz for ever if it were taken for elastic. So both get a loan:
//   a <- max(a + T . d, -limit)      T: the force held over the period, d: the hand's way in it; a: what is owed
//   x  = max(a - limit, 0), no more than max(T . d, 0),      a <- a - x
// T . d - x counts as ideal, x does not: the brake sees it. Bumps that give back what they took owe between - limit and
// limit for ever, and are never braked; what they give for good they give only once, for a debt outlasts the touch: it fades in
// kDebtMemory_s, so that limit / kDebtMemory_s is the power that may be had of it for ever. Where the push falls, and the limit with it,
// nothing falls due that was not given in the round itself. The force is not changed here.
// limit: of a texture K k d H, what one bump of height H holds under the present pressure (falling to it within kLoanMemory_s where
// the hand lifts); of a tap the stated share of m v^2 / 2.
//
// In terms of passivity.h: S = T and H = T - 2 x d / |d|^2, so that (S + H)/2 . d = T . d - x.
// Of a force that goes on evenly between the rounds, as a shaded contact's does, (T_(n-1) + T_n)/2 . d stands for T . d: what the hold
// alone gives or takes would add up to as much as is lent. Of that kUnfelt_N . |d| are forgiven: a proxy creeps over facets by steps, and
// a shaded direction is wrong by some hundredths of a degree, so that strokes which nobody would call driven give 0.001 to 0.006 N of it.
// And what the hand is known to have given besides for nothing is paid off a debt, and never makes a credit: whatever was lent by then, hand and
// scene together have no more than before.
// Of a wrench T . d is that of force and torque together, one loan for both: what turns about its contact gives by one what it takes by
// the other. What falls due is shared out to the two by what each gave.
// Thread: haptic loop. Cost: about 5 ns. Source: ours; the idea of a bounded tank is that of S. Stramigioli and C. Secchi
// (energy tanks), here without the port's dynamics.
#pragma once

#include "haptics/coupling/elastic_force.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

inline constexpr double kLoanMemory_s = 1.0;
inline constexpr double kDebtMemory_s = 10.0;
inline constexpr double kUnfelt_N = 0.01;
inline constexpr double kUnfeltAt_m =
    0.015;  ///< and of a turn that at this distance, as of a handle

/// Fixed at load.
struct EnergyLoanSettings {
    double debt_memory_s = kDebtMemory_s;  ///< in which a debt fades, 0.01 to 1e6
    double share = 1.0;                    ///< of what is asked to be lent, 0 to 100
};

/// How much is owed, and how much of what is given goes beyond the limit.
class LoanAccount {
  public:
    LoanAccount() = default;
    /// Takes settings that `validate` accepted (surface_plan.h).
    explicit LoanAccount(const EnergyLoanSettings& settings) noexcept : settings_(settings) {}

    /// The limit is at least `limit_J` now; a higher one from before falls towards it in `dt_s`. Not finite or negative: 0.
    void allow(double limit_J, double dt_s) noexcept;
    /// Nothing is owed and nothing allowed.
    void settle() noexcept { limit_J_ = owed_J_ = 0.0; }
    /// Of a debt, not of a credit.
    void forgive(double energy_J) noexcept;
    /// x: what of `given_J` falls due at once; of a debt `paid_J` is paid before. Of what is no number nothing is given.
    [[nodiscard]] double take(double given_J, double paid_J = 0.0) noexcept;
    /// Of energy that comes all at once, and may be refused: whether so much more is lent. Where it is, it is owed; what comes back, below
    /// 0, always is taken.
    [[nodiscard]] bool may_give(double given_J) noexcept;

    [[nodiscard]] double owed_J() const noexcept { return owed_J_; }
    [[nodiscard]] double limit_J() const noexcept { return limit_J_; }

  private:
    void owe(double given_J) noexcept;

    EnergyLoanSettings settings_{};
    double limit_J_ = 0.0;
    double owed_J_ = 0.0;
};

class EnergyLoan {
  public:
    EnergyLoan() = default;
    explicit EnergyLoan(const EnergyLoanSettings& settings) noexcept : account_(settings) {}

    /// As LoanAccount::allow.
    void allow(double limit_J, double dt_s) noexcept { account_.allow(limit_J, dt_s); }
    /// The surface was left `dt_s` ago, or in the round before: what is owed stays owed.
    void leave(double dt_s) noexcept;
    /// Nothing is owed and nothing allowed, as before a new tap.
    void settle() noexcept;

    /// Counts the period that has just ended with the hand `motion_W` further, and takes over the force of the next.
    [[nodiscard]] ElasticForce step(const Vector3& next_W, const Vector3& motion_W) noexcept;
    /// The same of a force that goes on evenly from round to round, upon a surface against which the hand went `against_W`. `paid_J`: what
    /// the hand gave besides and does not get back.
    [[nodiscard]] ElasticForce step_evenly(const Vector3& next_W, const Vector3& motion_W,
                                           const Vector3& against_W, double paid_J) noexcept;

    [[nodiscard]] double owed_J() const noexcept { return account_.owed_J(); }
    [[nodiscard]] double limit_J() const noexcept { return account_.limit_J(); }

  private:
    LoanAccount account_;
    Vector3 force_W_{Vector3::Zero()};
};

/// Likewise of a wrench, whose moments are about where the motion is told.
class WrenchLoan {
  public:
    WrenchLoan() = default;
    explicit WrenchLoan(const EnergyLoanSettings& settings) noexcept : account_(settings) {}

    struct Counted {
        ElasticForce force{};
        ElasticForce torque{};
    };
    /// A shift and a rotation vector.
    struct Way {
        Vector3 shift_W{Vector3::Zero()};
        Vector3 turn_W{Vector3::Zero()};
    };

    void allow(double limit_J, double dt_s) noexcept { account_.allow(limit_J, dt_s); }
    void leave(double dt_s) noexcept;
    void settle() noexcept;
    [[nodiscard]] Counted step(const Wrench& next_W, const Way& motion_W) noexcept;
    [[nodiscard]] Counted step_evenly(const Wrench& next_W, const Way& motion_W,
                                      const Way& against_W) noexcept;

    [[nodiscard]] double owed_J() const noexcept { return account_.owed_J(); }

  private:
    [[nodiscard]] Wrench lend(const Wrench& wrench_W, const Way& motion_W,
                              const Way& against_W) noexcept;

    LoanAccount account_;
    Wrench wrench_W_{};
};

}  // namespace fulcrum
