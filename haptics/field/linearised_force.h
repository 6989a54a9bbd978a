// A force that a lesson computed at its own slow rate, kept smooth and bounded at the haptic rate.
//
//   law     F(x, v) = F0 + K (x - x0) + B (v - v0)  of the newest accepted answer
//   blend   at a new answer the difference to the former model at this x, v is kept and taken away
//           over kBlend_s: F <- F + (F_former - F_new) (1 - age / kBlend_s): the force is continuous
//   gains   |K| <= kMaxLinearStiffness, |B| <= kMaxLinearDamping (Frobenius norms, scaled as a whole);
//           the symmetric part of B loses its positive eigenvalues: v.B v > 0 would feed energy into
//           the hand
//   age     factor 1 up to the timeout, then in a straight line to 0 at twice the timeout
//
// Thread: haptic loop. Cost: about 20 ns; about 0.3 us when a new answer comes (a 3 x 3 eigenproblem).
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
    stiffness_clamped = 1U << 1,      ///< |K| was above kMaxLinearStiffness_N_per_m
    damping_clamped = 1U << 2,        ///< |B| was above kMaxLinearDamping_Ns_per_m
    active_damping_removed = 1U << 3  ///< B would have pushed in the direction of motion
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
inline constexpr double kBlend_s = 1.0 / 60.0;  ///< one answer of a lesson at 60 Hz

/// The law alone: newtons at `position_W` metres and `velocity_W` metres per second.
[[nodiscard]] Vector3 compute_linearised_force(const LinearisedForce& model,
                                               const Vector3& position_W,
                                               const Vector3& velocity_W) noexcept;
/// Bounds the gains of `model` in place and says what was changed; refuses what is not finite by
/// changing nothing.
[[nodiscard]] LinearisationNote bound_gains(LinearisedForce& model) noexcept;

/// A lesson's force while it runs.
class LinearisedForceStage {
  public:
    /// `timeout_s`: an answer older than this begins to fade.
    explicit LinearisedForceStage(double timeout_s) noexcept : timeout_s_(timeout_s) {}

    /// No answer yet, no force.
    void reset() noexcept;
    /// Force in newtons at `now_s`. `newest` is taken when its stamp is newer than the last
    /// accepted one and not negative.
    [[nodiscard]] Vector3 step(const LinearisedForce& newest, const Vector3& position_W,
                               const Vector3& velocity_W, double now_s) noexcept;
    /// What was changed in or refused of the newest answer.
    [[nodiscard]] LinearisationNote notes() const noexcept { return notes_; }

  private:
    [[nodiscard]] Vector3 compute_blended(const Vector3& position_W, const Vector3& velocity_W,
                                          double now_s) const noexcept;

    double timeout_s_;
    bool has_model_ = false;
    double seen_stamp_s_ = -1.0;  // newest stamp looked at, accepted or refused
    double accepted_at_s_ = 0.0;
    LinearisedForce model_{};
    Vector3 offset_W_{Vector3::Zero()};  // former model minus new one when the new one came
    LinearisationNote notes_ = LinearisationNote::none;
};

}  // namespace fulcrum
