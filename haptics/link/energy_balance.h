// Keeps a delayed, lossy link from giving energy that nobody put in: one side of a time-domain passivity network.
//
// In a round of length T one side's force A acted along the motion d. An encoder shows in one round what the hand went in several, so A
// is this round's force or the mean since the last motion (of 50 ms at most), whichever counts less as put in here. Its port takes in or
// gives out
//   gave  += max(+-A.d, 0)      what this side puts into the link: told to the other in every packet, a sum that only grows, so
//                               that a lost packet loses nothing
//   out    = max(-+A.d, 0)      what the link gives out on this side
// and may give out no more than the other has put in, as far as this side has heard:
//   balance = min(kept balance + heard + paid - out, headroom)        kept: credit fades, 1 - T / memory; a debt stays
//   paid                       what this side puts in while it is in debt goes there first, and is not told
// Below zero the link has been active here by -balance. At the arm (force in, motion out) the hand is braked:
//   A gets  - alpha d / T,   alpha = min(-balance T / |d|^2, m / 8 T)
// and, in a debt E = -balance above E_b, what would give it more along the way is left out
//   A gets  - s max(A.d, 0) d / |d|^2,   s = min(E / E_b - 1, 1)
// where d is how the hand is seen to go (seen_way.h), through rounds that show no motion too. For the brake alone pays m v^2 / 8 a round,
// and a spring K that is held through a round gives K T^2 v^2 / 2: more, where K > m / 4 T^2, as on an arm whose rounds are late by some
// milliseconds. So the hand is given no more than what the other side has put in, the headroom, 2 E_b, what the gate's slew leaves, what
// some 2 ms give after it turned round, and, where it goes so slowly that it seems to rest, one encoder's step in 50 ms: 3 mW at 3 N and
// 55 um.
// At the scene (motion in, force out) the hand is moved on in the scene, along the force, so that the scene has taken less:
//   x gets  + s,   s = A min(-balance / |A|^2, furthest / |A|),   and balance gets  + A.s
// What earned balance is a short-lived credit (headroom, memory), as in coupling/passivity.h: minutes of stirring in honey
// license no buzz. A hand that was moved aside comes back for nothing in free space, and in contact for what is left of the
// balance and for lent_W: a wall that is pressed calmly is soon felt whole again, and what the link may give so is less than a
// hand takes that moves at 4 cm/s (2.6 Ns/m, human_impedance.h).
//
// Thread: the loop that owns the link. Cost: a few nanoseconds.
// Source: J.-H. Ryu, J. Artigas, C. Preusche 2010, A passive bilateral control scheme for a teleoperator with time-varying
// communication delay, Mechatronics 20(7), section 3 (energies in and out apart, each bounded by what the other side has sent);
// J.-H. Ryu, D.-S. Kwon, B. Hannaford 2004, Stable teleoperation with time-domain passivity control, IEEE T-RA 20(2). The
// brake's bound is that of coupling/passivity.h; headroom, memory and lent power
// are ours: without the last a hand in contact stays aside, and with 10 ms each way feels a fiftieth of the wall.
#pragma once

#include "haptics/base/error.h"
#include "haptics/math/spatial.h"

#include <cstdint>

namespace fulcrum {

struct EnergyBalanceSettings {
    double headroom_J = 5.0e-4;  ///< 0 to 0.01
    double memory_s = 0.1;       ///< 0.01 to 10
    double lent_W = 4.0e-3;      ///< to bring a shifted hand back in contact, 0 to 0.01
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const EnergyBalanceSettings& settings);

/// Which way energy goes that is A.d > 0: at the arm it goes out of the link, to the hand; at the scene it goes in.
enum class LinkSide : std::uint8_t { arm, scene };

/// One port, translation or turning, on one side.
class EnergyBalance {
  public:
    EnergyBalance(LinkSide side, const EnergyBalanceSettings& settings) noexcept
        : side_(side), settings_(settings) {}

    /// Counts a round: `force` acted along `motion` (N and m, or Nm and rad), `dt_s` long; `heard_J` is the newest sum that the
    /// other side has told. What is not finite, and a sum that shrinks, is not counted.
    void step(const Vector3& force, const Vector3& motion, double heard_J, double dt_s) noexcept;
    /// Begins anew with sums at zero.
    void reset() noexcept;

    /// What this side has put in since the beginning, joules, to be told.
    [[nodiscard]] double gave_J() const noexcept { return gave_J_; }
    /// How much more the link has given out here than it may have; 0 when it has not.
    [[nodiscard]] double excess_J() const noexcept { return balance_J_ < 0.0 ? -balance_J_ : 0.0; }
    /// The largest excess so far.
    [[nodiscard]] double peak_excess_J() const noexcept { return peak_J_; }

    /// The damping that takes the excess back in a round like the last: alpha above, at most `most`.
    [[nodiscard]] double compute_damping(const Vector3& motion, double dt_s,
                                         double most) const noexcept;
    /// What is left of `force` while the link is in debt here, where it would give more along `motion`: A above.
    [[nodiscard]] Vector3 hold_back(const Vector3& force, const Vector3& motion) const noexcept;
    /// Moves the scene's hand along `force` so far that the scene has taken less by the excess, at most `furthest`: how far.
    /// What that takes back is settled.
    [[nodiscard]] Vector3 shift(const Vector3& force, double furthest) noexcept;
    /// Moves it by `wish`, towards where it belongs, in a round of `dt_s`, or as far as balance and lent power pay for: how far.
    [[nodiscard]] Vector3 shift_back(const Vector3& force, const Vector3& wish,
                                     double dt_s) noexcept;

  private:
    LinkSide side_;
    // The mean force since the last motion, this round's with it.
    [[nodiscard]] Vector3 find_mean_force(const Vector3& force, const Vector3& motion,
                                          double dt_s) noexcept;

    EnergyBalanceSettings settings_;
    Vector3 impulse_{Vector3::Zero()};  // of rounds that showed no motion
    double waited_s_ = 0.0;             // in those
    double gave_J_ = 0.0;
    double heard_J_ = 0.0;
    double balance_J_ = 0.0;
    double peak_J_ = 0.0;
};

}  // namespace fulcrum
