// Watches the energy that the hand is given through one port (force and motion, or torque and turning), and brakes when it is
// more than the scene itself, felt without sampling, would give.
//
// Observer. Round n reads the hand at x_n, asks C_n = S_n + D_n (S elastic, see elastic_force.h; D the dampers) and sends A_n,
// which the device holds to the next round. With d_n = x_n - x_(n-1) the hand was given
//   A_(n-1) . d_n                                    exactly, whatever way it took: the force was constant (Ryu, Kim and
//                                                    Hannaford: E_n = sum of f_(k-1) . (x_k - x_(k-1)))
// and the ideal scene would have given
//   g_(n-1) ((S_(n-1) + H_n)/2 . d_n + kink)         g: what the gate let through
//   H_n = S_n                      where the scene goes on between the rounds: a contact and a tool, whose anchors follow the hand
//                                  and the solids; hand and anchor that move on together get just what was held
//   H_n = S at x_n in the scene    where the scene changes at the rounds alone: an anchor that is set, a switch, an answer; what
//         of round n-1             changed there is not the hand's doing, and gives no excess
// which is exact where S is affine along the way (spring, weight, flat wall, a lesson's slopes) and wrong by |d|^3 |S''| / 12
// elsewhere (magnet, round and moving solids). Dampers have no such claim: what they do must take. So the excess grows by
//   e_n = A_(n-1).d_n - g_(n-1) ((S_(n-1) + H_n)/2 . d_n + kink) - b_device |d_n|^2 / T
// (own friction takes at least that: Cauchy and Schwarz). A weight gives 0, lowered or not. A spring k with a damper b:
//   e = (k T/2 - b) |d|^2 / T:    above 0 below the line b = k T/2 of Colgate and Schenkel.
// A gate that lags (slew) or clips gives A beside C: g = A.C / |C|^2 within [0, 1]; what is left over counts as it is.
// Of a spring that the gate clips, g k |d|^2 / 2 too much is counted: the clipped force has no slope any more.
// kink: where a contact begins or ends within a period S is not affine. The ideal spring gives or takes no more than the
// energy U that it has on the side that touches: compute_kink_J. Exact for a wall at rest.
//
// Budget. E_n = max(E_(n-1) (1 - T / memory) + e_n, -headroom). What dampers earned is a small, short-lived credit, so
// that minutes of stirring in honey license no buzz: the delay that Ryu, Preusche et al. find in an observer
// that sums from the start. While the brake suffices, and in spans well below `memory`, the hand gets at
// most the headroom beyond the ideal.
//
// Controller. If the hand goes on as it went, the next period adds D_n.d_n and the spring's leak l = g (S_(n-1) - H_n)/2 . d_n:
//   E_n + D_n.d_n + max(l, 0) = w > 0:    A gets  - alpha d_n / T,   alpha = min(w T / |d_n|^2, m / 8 T)
// D is counted in advance, or a wall would be braked for what its own damper takes a millisecond later. The bound: a mass m
// under -alpha d/T, held, has the roots of z^2 - (1 - u/2) z + u/2, u = alpha T / m; they are real and above 0 up to
// u = 6 - sqrt 32 = 0.34. With u = 1/8, and 0.21 of the default coupling's damper, a bare handle does not overshoot at 1 kHz. A
// damper whose velocity is known late (a window of 8 ms) overshoots by 0.32 without this brake, and by 0.26 with it.
// Where no new pose has come d is zero, and yet the hand moves: the brake is then held, for two rounds, and the way that the next
// pose tells was gone in all of the time since. Without that, a device that tells poses and takes forces in every second round
// alone might see the rounds without a brake and no others.
// Where a surface is touched the brake takes no more than its push: a wall never holds fast.
// After this comes the gate. Where its slew limit holds all the time the brake comes late as well, and a wall can still buzz: at
// 500 N/s a bare handle that comes at 0.1 m/s does so on walls without a damper above 2000 N/m.
//
// Thread: haptic loop. Cost: about 30 ns a port (315 instructions).
// Source: B. Hannaford, J.-H. Ryu 2002, Time-domain passivity control of haptic interfaces, IEEE T-RA 18(1) (observer, series
// controller); J.-H. Ryu, Y. S. Kim, B. Hannaford 2004, Sampled- and continuous-time passivity and stability of virtual
// environments, IEEE T-RO 20(4) (the hold's energy, prediction by one sample); J.-H. Ryu, C. Preusche, B. Hannaford,
// G. Hirzinger 2005, Time domain passivity control with reference energy following, IEEE T-CST 13(5); J. E. Colgate,
// G. Schenkel 1997, Passivity of a class of sampled-data systems, J. Robotic Systems 14(1). g, kink and memory are ours.
#pragma once

#include "haptics/base/error.h"
#include "haptics/coupling/coupling_settings.h"
#include "haptics/coupling/elastic_force.h"
#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

/// Fixed at load.
struct PassivitySettings {
    bool on = true;  ///< false for tests and benchmarks alone: then nothing watches
    double handle_mass_kg =
        kHandleMass_kg;  ///< the lightest that may hang on the device, 0.001 to 10
    double handle_inertia_kg_m2 = 1.0e-5;  ///< likewise: the mass on 15 mm; 1e-8 to 1
    double headroom_J =
        1.0e-4;  ///< most that dampers earn, 0 to 0.01: moves the bare handle at 67 mm/s
    double memory_s =
        0.1;  ///< time constant in which headroom and excess are forgotten, 0.01 to 10
};

/// Refuses settings outside the ranges named at each field, NaN included.
[[nodiscard]] Expected<void> validate(const PassivitySettings& settings);

/// What is fixed for one port.
struct PortLimits {
    double inertia = kHandleMass_kg;  ///< kg or kg m^2
    double device_damping = 0.0;      ///< b_device: Ns/m or Nms/rad, 0 when it is unknown
    double period_s = 0.001;          ///< T of the loop
};

/// One round of one port: newtons and metres of the hand, or newton metres and radians; all in one frame.
struct PortRound {
    Vector3 motion{Vector3::Zero()};  ///< d_n
    Vector3 asked{Vector3::Zero()};   ///< C_n
    ElasticForce elastic{};           ///< S_n and H_n
    double kink_J = 0.0;
    /// Of a surface that is touched: unit normal away from it, and how strongly it pushes along that. The brake takes from
    /// this push, and never makes a pull of it. Zero in free space.
    Vector3 normal{Vector3::Zero()};
    double push = 0.0;
    double dt_s = 0.0;   ///< since the last round
    bool is_new = true;  ///< false: the device has told nothing since, and `motion` is zero
};

/// The spring of a contact in one round; no energy where nothing is touched.
struct ContactSpring {
    Vector3 force{Vector3::Zero()};
    double energy_J = 0.0;            ///< U, in metres of the hand
    Vector3 normal{Vector3::Zero()};  ///< unit, away from the surface
    double push = 0.0;                ///< along it, of spring and damper together
};
/// What must be added to the trapezoid (S_before + S_now)/2 . d when a contact began (the ideal spring takes U_now at most) or
/// ended (it gives U_before at most) on the way; 0 while it lasts.
[[nodiscard]] double compute_kink_J(const ContactSpring& before, const ContactSpring& now,
                                    const Vector3& motion) noexcept;

/// Observer and controller of one port. Order in a round: `step`, the gate, `sent`.
class PassivityController {
  public:
    /// Takes settings that `validate` accepted.
    PassivityController(const PassivitySettings& settings, const PortLimits& limits) noexcept;

    /// Counts the period that has just ended and returns the brake to be added to `asked`. A round with a number that is not
    /// finite or absurd (above 1e9), or a time that does not go on, is not counted: the port begins anew.
    [[nodiscard]] Vector3 step(const PortRound& round) noexcept;
    /// What the gate made of asked and brake: A_n.
    void sent(const Vector3& applied) noexcept;
    /// Begins anew, as after a jump of the hand: no excess, no headroom. Peak and braked energy stay.
    void reset() noexcept;

    [[nodiscard]] const PortEnergy& energy() const noexcept { return energy_; }
    /// alpha's bound m / 8 T.
    [[nodiscard]] double largest_damping() const noexcept { return largest_damping_; }

  private:
    void observe(const PortRound& round, double since_s) noexcept;
    [[nodiscard]] Vector3 compute_brake(const PortRound& round, double since_s) const noexcept;
    [[nodiscard]] Vector3 hold_brake(const PortRound& round) const noexcept;

    double headroom_J_;
    double memory_s_;
    double largest_damping_;
    double device_damping_;
    PortEnergy energy_{};
    double hold_s_;          // how long a brake is held without a new pose
    double waited_s_ = 0.0;  // since the last new pose, this round not counted
    double leak_J_ = 0.0;    // l of the period that has just ended
    // Of the last round, where there was one.
    bool follows_ = false;
    Vector3 elastic_{Vector3::Zero()};  // S
    Vector3 brake_{Vector3::Zero()};
    Vector3 asked_{Vector3::Zero()};    // C with the brake
    Vector3 applied_{Vector3::Zero()};  // A
    double share_ = 0.0;                // g
};

}  // namespace fulcrum
