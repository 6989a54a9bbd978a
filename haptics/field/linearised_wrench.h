// A force and a torque that a lesson computed at its own slow rate, kept smooth and bounded at the
// haptic rate.
//
//   law     F(x, v) = F0 + K (x - x0) + B (v - v0)      of the newest accepted answer
//           T(x)    = T0 + S (x - x0)                   about the tool's origin
//           each no longer than max_force, max_torque
//   age     F <- F g: factor g = 1 up to the timeout, then in a straight line to 0 at twice the
//           timeout; the torque likewise
//   blend   at a new answer the difference to what was felt before is kept and taken away in a
//           straight line: F <- F + D (1 - age / T_b), D = F_before - F_new at this x, v;
//           T_b = e^2 max(blend_s, |D_F| / kAnswerSlew_N_per_s, |D_T| / kAnswerSlew_Nm_per_s)
//           e   the asked |K|, |B|, |S| over its bound, the largest of the three, at least 1
//   gains   |K|, |B|, |S| bounded (Frobenius norms, scaled as a whole); the symmetric part of B
//           loses its positive eigenvalues: v.B v > 0 would feed energy into the hand
//
// So the wrench is continuous, and what the answers themselves do to a hand that holds still is no
// faster than kAnswerSlew: an answer that changes its mind 60 times a second between any two forces
// moves the hand's force by kAnswerSlew / 60 = 0.8 N and no more. The slopes K, B, S act at once: a
// delay in them would make a spring shake that now stands. They feel the hand's own motion only.
// An answer steeper than its bound would still be a spring of that steepness, only 60 times a second:
// with e = 2.5 the usual arm would swing 15 mm at 4 Hz on it. Slowed down by e^2 it comes to rest.
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

#include "haptics/coupling/elastic_force.h"
#include "haptics/field/field_plan.h"
#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

#include <cstdint>

namespace fulcrum {

/// Why an answer was changed or refused; bits.
enum class LinearisationNote : std::uint8_t {
    none = 0,
    refused_not_finite =
        1U << 0,  ///< NaN, infinity or an absurd size: the former answer stays and ages
    stiffness_clamped = 1U << 1,        ///< |K| was above its limit
    damping_clamped = 1U << 2,          ///< |B| was above its limit
    active_damping_removed = 1U << 3,   ///< B would have pushed in the direction of motion
    torque_stiffness_clamped = 1U << 4  ///< |S| was above its limit
};
[[nodiscard]] constexpr LinearisationNote operator|(LinearisationNote a,
                                                    LinearisationNote b) noexcept {
    return static_cast<LinearisationNote>(static_cast<std::uint8_t>(a) |
                                          static_cast<std::uint8_t>(b));
}
[[nodiscard]] constexpr bool has(LinearisationNote notes, LinearisationNote note) noexcept {
    return (static_cast<std::uint8_t>(notes) & static_cast<std::uint8_t>(note)) != 0;
}

/// Reaches the hard cap on torque (1 Nm) over the 5 mm in which the stiffness reaches that on force.
inline constexpr double kMaxFeltTorqueStiffness_Nm_per_m = 200.0;
inline constexpr double kBlend_s = 1.0 / 60.0;  ///< one answer of a lesson at 60 Hz
/// A new answer comes to the usual limits (5 N, 0.3 Nm) within a tenth of a second, as a declared
/// field does.
inline constexpr double kAnswerSlew_N_per_s = 50.0;
inline constexpr double kAnswerSlew_Nm_per_s = 3.0;

/// What a lesson's answers may do; world frame. At a workspace scale s the gains are those felt in
/// the hand divided by s.
struct LinearisedWrenchSettings {
    double timeout_s = 0.1;     ///< an answer older than this begins to fade; above 0
    double blend_s = kBlend_s;  ///< from one answer to the next; above 0
    double max_force_N = 10.0;
    double max_torque_Nm = 1.0;
    double max_stiffness_N_per_m = kMaxFeltStiffness_N_per_m;
    double max_damping_Ns_per_m = kMaxFeltDamping_Ns_per_m;
    double max_torque_stiffness_Nm_per_m = kMaxFeltTorqueStiffness_Nm_per_m;
};

/// The law alone: newtons, and newton metres about the tool's origin, at `position_W` metres and
/// `velocity_W` metres per second.
[[nodiscard]] Wrench compute_linearised_wrench(const LinearisedWrench& model,
                                               const Vector3& position_W,
                                               const Vector3& velocity_W) noexcept;
/// Bounds the gains of `model` in place and says what was changed; refuses what is not finite by
/// changing nothing.
[[nodiscard]] LinearisationNote bound_gains(LinearisedWrench& model,
                                            const LinearisedWrenchSettings& settings) noexcept;

/// A lesson's wrench while it runs.
class LinearisedWrenchStage {
  public:
    explicit LinearisedWrenchStage(const LinearisedWrenchSettings& settings) noexcept
        : settings_(settings) {}

    /// Newtons and newton metres at `now_s`. `newest` is looked at when its stamp is newer than the
    /// last one that was, not negative and not after `now_s`.
    [[nodiscard]] Wrench step(const LinearisedWrench& newest, const Vector3& position_W,
                              const Vector3& velocity_W, double now_s) noexcept;
    /// What was changed in or refused of the newest answer.
    [[nodiscard]] LinearisationNote notes() const noexcept { return notes_; }
    /// All of the last step's force but B v; held: moved along the former answer's slope.
    [[nodiscard]] const ElasticForce& elastic_force() const noexcept { return elastic_force_; }
    /// The last step's torque; held likewise.
    [[nodiscard]] const ElasticForce& elastic_torque() const noexcept { return elastic_torque_; }

  private:
    // A wrench, and how much of the model's slopes limits and age leave in it.
    struct Plain {
        Wrench wrench_W{};
        double force_share = 0.0;
        double torque_share = 0.0;
    };
    [[nodiscard]] Plain compute_plain(const Vector3& position_W, const Vector3& velocity_W,
                                      double now_s) const noexcept;
    [[nodiscard]] Plain compute_blended(const Vector3& position_W, const Vector3& velocity_W,
                                        double now_s) const noexcept;
    void hold_elastic(const Vector3& position_W) noexcept;
    void accept(const LinearisedWrench& model, double excess, const Vector3& position_W,
                const Vector3& velocity_W, double now_s) noexcept;

    LinearisedWrenchSettings settings_;
    bool has_model_ = false;
    double seen_stamp_s_ = -1.0;  // newest stamp looked at, accepted or refused
    double accepted_at_s_ = 0.0;
    double blend_s_ = kBlend_s;  // how long the offset takes to go
    LinearisedWrench model_{};
    Wrench offset_W_{};  // what was felt before minus the new answer, when it came
    LinearisationNote notes_ = LinearisationNote::none;
    ElasticForce elastic_force_{};
    ElasticForce elastic_torque_{};
    Vector3 last_position_W_{Vector3::Zero()};
    Plain last_{};
};

}  // namespace fulcrum
