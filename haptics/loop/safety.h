// The last gate before the device: whatever was computed, what leaves here is small, finite, and slow to change but for what is short.
//
//   waiting   output 0; commanded |f| < engage_below for engage_cycles faultless calls in a row: rising. So too, whatever is commanded, where
//             the hand has rested below rest_speed for rest_s without a fault: a force that is there from the start comes in softly. Not
//             after a hand that was too fast or given too much: what did that must become small first
//   rising    |f_k| <= |f_(k-1)| + soft_start_rate dt, for soft_start_s of summed dt and until what is commanded has come, but for
//             engage_below: then open. So what came late in that time comes softly too, and not at once when it is over
//   open      f = b + t: what lasts, b, goes towards what is commanded with |b_k - b_(k-1)| <= max_slew dt (rising has this part alone, and so
//             has a torque); t is what is commanded less b, |t| <= max_transient, softly less as I or Q come near their bounds:
//             I <- I (1 - dt / kImpulseMemory_s) + t dt      |I| <= transient_Ns
//             Q <- Q (1 - dt / kRingingMemory_s) + |t|^2 dt   Q <= transient_N2s
//             dt: the time since the last call, or a period where that is longer, for which t is about to be held; the next call puts right
//             for how long it was. In other phases t = 0, and I and Q are forgotten as fast; no fault nor stop empties them
//   fading    any fault: t ends at once, and what of b points along f is f_0: f(t) = f_0 (1 - t / fade_s), whatever is commanded, then
//             waiting; each call counts as one period at least, so that no clock can hold a force that should go
//   stopped   emergency stop: the same fade, then 0 until `reset`
// So a tap, short and to both sides, arrives as it was commanded: b follows it by a little, and t is the rest. A push that lasts comes with
// the slew: |t| / max_slew after it was commanded t is nothing, for b is there. With a slew below the usual one the bounds of t are as much
// less, that of Q by the square.
// What a hand gets at most beyond b, which alone obeys the slew (figures of the settings as they ship):
//   at any time    max_transient                                                            4 N; f itself stays below max_force
//   in a blow      transient_Ns from rest, twice that from one side to the other            0.02 and 0.04 N s
//   of energy      (2 transient_Ns)^2 / 2 m to a mass m that rests and is free              18 mJ to a handle of 45 g, 0.8 mJ to a hand of 1 kg
//   a buzz         sqrt(transient_N2s (1 / kRingingMemory_s + 1 / D)) in the root mean      0.45 N for ever, 0.51 N in any second;
//                  square of any D seconds, at any frequency                                one of 4 N is softer from 3 ms on
//   where a call   comes d later than the one before it led to expect: t is held for so      max_transient d, 0.06 N s in 15 ms, more
//                  long, and what it was more counts in I and Q: nothing more then
// Proof. Summed from call i to j the recursions give sum t dt = I_j - I_i + sum I dt / kImpulseMemory_s: in a time that is short against the
// memory, at most 2 transient_Ns; and sum |t|^2 dt <= transient_N2s (1 + D / kRingingMemory_s). `ring` scales t so that neither leaves its bound,
// or goes further beyond one that a late call or a smaller slew left it at, whatever was commanded; and b + t lies between b and what is commanded,
// both below max_force. In a longer time a t of one sign may stay, of transient_Ns / kImpulseMemory_s, 0.4 N, at most.
// Limits scale the whole vector, so that its direction stays: f <- f min(1, max_force / |f|). Torque
// obeys the same laws with every rate multiplied by max_torque / max_force. A call longer than
// kLongestStep_s rises no further than one of that length. The last instruction compares with the
// limits again and gives zero if they do not hold.
//
// Thread: haptic loop. Cost: about 50 ns.
// Source: engagement below 0.2 N and a rise over two seconds are CHAI3D's practice; the rest is ours.
#pragma once

#include "haptics/base/error.h"
#include "haptics/base/fault.h"
#include "haptics/handover/messages.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/math/spatial.h"

#include <limits>

namespace fulcrum {

inline constexpr double kHardForceCap_N = 10.0;   ///< no setting, plan or bug passes this
inline constexpr double kHardTorqueCap_Nm = 1.0;  ///< likewise
inline constexpr double kMostTransient_N = 5.0;  ///< likewise of what may come faster than the slew
inline constexpr double kInsaneForce_N =
    1.0e6;  ///< a stage that asks for more than this has failed
inline constexpr double kImpulseMemory_s = 0.05;  ///< longer than any blow
inline constexpr double kRingingMemory_s = 0.3;   ///< longer than a tap rings
inline constexpr double kLongestStep_s =
    0.01;  ///< a longer call does not rise further than this one

/// Refuses settings outside the ranges named at each field of SafetySettings, NaN included.
[[nodiscard]] Expected<void> validate(const SafetySettings& settings);

/// The gate's last instruction: `wrench` itself when neither limit nor hard cap is passed, else zero. A comparison that NaN
/// fails, so that no bit pattern of wrench or limits gets through above a cap.
[[nodiscard]] Wrench compute_last_check(const Wrench& wrench, double max_force_N,
                                        double max_torque_Nm) noexcept;

/// One gate stands before one device. See the head of this file for its laws.
class SafetyGate {
  public:
    /// Takes settings that `validate` accepted; others are pulled to the nearest safe value (NaN to
    /// the strictest). `period_s` is the loop's, 0.0002 to 0.002; any other is taken as 0.002.
    explicit SafetyGate(const SafetySettings& settings, double period_s = 0.001) noexcept;

    /// What may be sent to the device now. `commanded_D` newtons and newton metres; `dt_s` since
    /// the last call: NaN, negative or infinite counts as Fault::command_invalid, and so does a
    /// commanded wrench that is not finite. A hand of which no speed is known, or NaN, never rests.
    [[nodiscard]] Wrench pass(
        const Wrench& commanded_D, Fault faults, double dt_s,
        double hand_m_per_s = std::numeric_limits<double>::infinity()) noexcept;

    /// From now on no faster than that either, 10 newtons a second or more; transients are as much less. NaN is 10.
    void limit_slew(double max_slew_N_per_s) noexcept;

    /// Leaves `stopped` (or any other phase) for `waiting` with zero force: a person has said that
    /// it is safe.
    void reset() noexcept;

    /// Zero at once, with nothing left to fade; a stop stays a stop.
    void silence() noexcept;

    /// The largest force in newtons that the next `pass` may let through, whatever is commanded and without a fault.
    [[nodiscard]] double find_most_N(double dt_s) const noexcept;
    /// The same of the torque, newton metres.
    [[nodiscard]] double find_most_Nm(double dt_s) const noexcept;

    /// True while a fade, of a fault or of a stop, has not come to zero.
    [[nodiscard]] bool is_fading() const noexcept;

    /// Whether it is stopped and the fade has come to zero: nothing is let through until `reset`.
    [[nodiscard]] bool is_still() const noexcept {
        return phase_ == GatePhase::stopped && !is_fading();
    }

    /// How far forces are let through now.
    [[nodiscard]] GatePhase phase() const noexcept { return phase_; }
    /// Faults that the last `pass` saw: those handed in and those it found itself.
    [[nodiscard]] Fault faults() const noexcept { return faults_; }
    /// The force limit in newtons that holds in this gate, never above kHardForceCap_N.
    [[nodiscard]] double max_force_N() const noexcept { return settings_.max_force_N; }
    /// Likewise of the torque, never above kHardTorqueCap_Nm.
    [[nodiscard]] double max_torque_Nm() const noexcept { return settings_.max_torque_Nm; }

  private:
    void enter(GatePhase phase) noexcept;
    [[nodiscard]] bool lets_through(double dt_s) const noexcept {
        return (phase_ == GatePhase::rising || phase_ == GatePhase::open) && dt_s >= 0.0;
    }
    [[nodiscard]] bool stays_rising(double dt_s) const noexcept;
    // How much b may grow in the next `pass` of an open gate.
    [[nodiscard]] double find_growth_N(double dt_s) const noexcept;
    void judge(const Wrench& commanded, double dt_s, double hand_m_per_s) noexcept;
    [[nodiscard]] bool may_rise(const Wrench& commanded, double dt_s, double hand_m_per_s) noexcept;
    void follow(const Wrench& limited, double dt_s) noexcept;
    void count_held(double dt_s) noexcept;
    void forget(double dt_s) noexcept;
    [[nodiscard]] Vector3 ring(const Vector3& beyond_N, double dt_s) noexcept;
    void fade(double dt_s) noexcept;

    SafetySettings asked_;
    SafetySettings settings_;  // as they are kept
    double period_s_;
    double torque_per_force_m_ =
        0.0;  // max_torque / max_force: the torque law in the force law's units
    GatePhase phase_ = GatePhase::waiting;
    Fault faults_ = Fault::none;
    Wrench output_D_{};                     // what the last call gave
    Wrench base_D_{};                       // b: what lasts of it
    Vector3 transient_N_{Vector3::Zero()};  // t of the last call
    double counted_s_ = 0.0;                // for so long I and Q have it held
    Vector3 impulse_Ns_{Vector3::Zero()};   // I
    double ringing_N2s_ = 0.0;              // Q
    Wrench fade_from_D_{};                  // f_0
    double fade_age_s_ = 0.0;
    double rise_age_s_ = 0.0;
    int calm_cycles_ = 0;
    double rested_s_ = 0.0;
    bool rest_counts_ = true;      // a hand that rests opens it
    bool opened_at_rest_ = false;  // so what is commanded may be large
    bool has_come_ = true;         // in the last call: what was commanded, but for engage_below
};

}  // namespace fulcrum
