// A force and a torque that a lesson computed at its own slow rate, kept smooth and bounded at the
// haptic rate.
//
//   law     F(x, v) = F0 + K (x - x0) + B (v - v0)      of the newest accepted answer
//           T(x)    = T0 + S (x - x0)                   about the tool's origin
//   blend   at a new answer the difference to the former model at this x, v is kept and taken away
//           over kBlend_s: F <- F + (F_former - F_new) (1 - age / kBlend_s): the force is continuous;
//           the torque likewise
//   gains   |K| <= kMaxLinearStiffness, |B| <= kMaxLinearDamping, |S| <= kMaxTorqueStiffness
//           (Frobenius norms, scaled as a whole); the symmetric part of B loses its positive
//           eigenvalues: v.B v > 0 would feed energy into the hand
//   age     factor 1 up to the timeout, then in a straight line to 0 at twice the timeout, for both
//
// Why there is no dT/dv = C. With w the turning, F = B v and T = C v put the power
//   v.B v + w.C v = (v, w) [B  C^T/2; C/2  0] (v, w)
// into the hand. A matrix with a zero on its diagonal is negative semidefinite only when that row is
// zero: for any C but 0 there is a turning that draws energy from it, however much B brakes. So a
// torque's dependence on velocity is felt from answer to answer only, at the lesson's rate, blended.
// S is no gradient of an energy either (the lesson knows no dF/d(turn)): a closed path in x and turn
// may gain |S| times what it encloses. Like K, which may push away from a point, it is what the lesson
// asked for, not bounded to be passive but in size.
//
// Thread: haptic loop. Cost: about 30 ns; about 0.3 us when a new answer comes (a 3 x 3 eigenproblem).
// Source: J. E. Colgate, G. Schenkel 1997, Passivity of a class of sampled-data systems: application to
// haptic interfaces, J. Robotic Systems 14(1), for why active damping is taken out; the rest is ours.
#pragma once

#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

#include <cstdint>

namespace fulcrum {

/// Why an answer was changed or refused; bits.
enum class LinearisationNote : std::uint8_t {
    none = 0,
    refused_not_finite =
        1U << 0,  ///< NaN, infinity or an absurd size: the former answer stays and ages
    stiffness_clamped = 1U << 1,        ///< |K| was above kMaxLinearStiffness_N_per_m
    damping_clamped = 1U << 2,          ///< |B| was above kMaxLinearDamping_Ns_per_m
    active_damping_removed = 1U << 3,   ///< B would have pushed in the direction of motion
    torque_stiffness_clamped = 1U << 4  ///< |S| was above kMaxTorqueStiffness_Nm_per_m
};
[[nodiscard]] constexpr LinearisationNote operator|(LinearisationNote a,
                                                    LinearisationNote b) noexcept {
    return static_cast<LinearisationNote>(static_cast<std::uint8_t>(a) |
                                          static_cast<std::uint8_t>(b));
}
[[nodiscard]] constexpr bool has(LinearisationNote notes, LinearisationNote note) noexcept {
    return (static_cast<std::uint8_t>(notes) & static_cast<std::uint8_t>(note)) != 0;
}

inline constexpr double kMaxLinearStiffness_N_per_m = 2000.0;
inline constexpr double kMaxLinearDamping_Ns_per_m = 50.0;
/// Reaches the hard cap on torque (1 Nm) over the 5 mm in which the stiffness reaches that on force.
inline constexpr double kMaxTorqueStiffness_Nm_per_m = 200.0;
inline constexpr double kBlend_s = 1.0 / 60.0;  ///< one answer of a lesson at 60 Hz

/// The law alone: newtons, and newton metres about the tool's origin, at `position_W` metres and
/// `velocity_W` metres per second.
[[nodiscard]] Wrench compute_linearised_wrench(const LinearisedWrench& model,
                                               const Vector3& position_W,
                                               const Vector3& velocity_W) noexcept;
/// Bounds the gains of `model` in place and says what was changed; refuses what is not finite by
/// changing nothing.
[[nodiscard]] LinearisationNote bound_gains(LinearisedWrench& model) noexcept;

/// A lesson's wrench while it runs.
class LinearisedWrenchStage {
  public:
    /// `timeout_s`: an answer older than this begins to fade.
    explicit LinearisedWrenchStage(double timeout_s) noexcept : timeout_s_(timeout_s) {}

    /// No answer yet, no force.
    void reset() noexcept;
    /// Newtons and newton metres at `now_s`. `newest` is taken when its stamp is newer than the
    /// last accepted one and not negative.
    [[nodiscard]] Wrench step(const LinearisedWrench& newest, const Vector3& position_W,
                              const Vector3& velocity_W, double now_s) noexcept;
    /// What was changed in or refused of the newest answer.
    [[nodiscard]] LinearisationNote notes() const noexcept { return notes_; }

  private:
    [[nodiscard]] Wrench compute_blended(const Vector3& position_W, const Vector3& velocity_W,
                                         double now_s) const noexcept;

    double timeout_s_;
    bool has_model_ = false;
    double seen_stamp_s_ = -1.0;  // newest stamp looked at, accepted or refused
    double accepted_at_s_ = 0.0;
    LinearisedWrench model_{};
    Wrench offset_W_{};  // former model minus new one when the new one came
    LinearisationNote notes_ = LinearisationNote::none;
};

}  // namespace fulcrum
