// One declared field: the plan fixes its law and coefficients; the lesson switches it, moves its anchor
// and weakens it.
//
//   F = strength * (elastic(x - anchor) - b v)   laws: spring.h, viscosity.h, magnet.h
//   strength  follows the commanded one (0 when off) by at most kStrengthRate_per_s
//   anchor    a <- a + (a_commanded - a) (1 - exp(-dt / kAnchorTime_s))
// A lesson speaks 60 times a second; both rules hide its steps from the hand.
//
// Thread: haptic loop. Cost: about 20 ns.
#pragma once

#include "haptics/base/error.h"
#include "haptics/coupling/elastic_force.h"
#include "haptics/field/field_plan.h"
#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

inline constexpr double kStrengthRate_per_s =
    10.0;  ///< a field switches on or off within a tenth of a second
inline constexpr double kAnchorTime_s = 0.02;  ///< one answer of the lesson and a bit

inline constexpr double kFarthestAnchor_m = 1.0e6;  ///< an anchor further away is no place

/// The steepest that a field gets, anywhere: newtons a metre and newton seconds a metre.
struct FieldGains {
    double stiffness_N_per_m = 0.0;
    double damping_Ns_per_m = 0.0;
};
/// Of a spring its coefficients, of a magnet the slope at its centre (magnet.h).
[[nodiscard]] FieldGains compute_largest_gains(const FieldPlan& plan) noexcept;

/// Refuses coefficients outside the ranges named at FieldPlan, and a magnet stiffer than 2000 N/m
/// at its centre.
[[nodiscard]] Expected<void> validate(const FieldPlan& plan);

/// What of a field's law depends on the place alone: newtons on a tool at `position_W`.
using ElasticLaw = Vector3 (*)(const FieldPlan& plan, const Vector3& anchor_W,
                               const Vector3& position_W) noexcept;

/// A field while it runs. Its law is chosen when it is built: a step of one kind passes no other on its way.
class FieldStage {
  public:
    /// Takes a plan that `validate` accepted. It starts switched off at the declared anchor.
    explicit FieldStage(const FieldPlan& plan) noexcept;

    /// Force in newtons after `dt_s`. A command that is not finite, or whose anchor is further away
    /// than kFarthestAnchor_m, keeps the former anchor and weakens to zero.
    [[nodiscard]] Vector3 step(const FieldCommand& command, const Vector3& position_W,
                               const Vector3& velocity_W, double dt_s) noexcept;
    /// The factor on the force now, 0 to 1.
    [[nodiscard]] double strength() const noexcept { return strength_; }
    /// What of the last step's force gives back the hand's work.
    [[nodiscard]] const ElasticForce& elastic() const noexcept { return elastic_; }

  private:
    FieldPlan plan_;
    ElasticLaw law_;
    double damping_Ns_per_m_;
    Vector3 anchor_W_;
    double strength_ = 0.0;
    ElasticForce elastic_{};
};

}  // namespace fulcrum
