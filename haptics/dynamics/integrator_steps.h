// What integrator.h is made of: a free turn, and the two longer steps, which write their result to `next` and leave `state` alone.
//
// Thread: that of the step. Cost: see integrator.h.
#pragma once

#include "haptics/dynamics/integrator.h"

namespace fulcrum {

/// Turns q freely for `dt_s`: with L / I_middle as a ball, and about the axes of the least and the greatest moment at the rates
/// L_i (1/I_i - 1/I_middle), forth and back so that it is reversible. L_W stays; seen from the body it turns back by the same angle.
[[nodiscard]] Quaternion compute_free_turn(const Inertia& inertia, const Quaternion& orientation,
                                           const Vector3& momentum_W, double dt_s) noexcept;

/// One Runge-Kutta-Munthe-Kaas step of order 4; four evaluations of the load.
void step_runge_kutta_4(const Inertia& inertia, const Load& load, double time_s, double dt_s,
                        const RigidState& state, RigidState& next) noexcept;

/// One backward Euler step by Newton. `next` counts only where the result says that it moved.
[[nodiscard]] StepResult step_backward_euler(const IntegratorSettings& settings,
                                             const Inertia& inertia, const Load& load,
                                             double time_s, double dt_s, const RigidState& state,
                                             RigidState& next) noexcept;

}  // namespace fulcrum
