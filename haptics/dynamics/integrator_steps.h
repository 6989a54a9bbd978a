// The two longer steps behind integrator.h: each writes its result to `next` and leaves `state` alone.
//
// Thread: that of the step. Cost: see integrator.h.
#pragma once

#include "haptics/dynamics/integrator.h"

namespace fulcrum {

/// One Runge-Kutta-Munthe-Kaas step of order 4; four evaluations of the load.
void step_runge_kutta_4(const Inertia& inertia, const Load& load, double time_s, double dt_s,
                        const RigidState& state, RigidState& next) noexcept;

/// One backward Euler step by Newton. `next` counts only where the result says that it moved.
[[nodiscard]] StepResult step_backward_euler(const IntegratorSettings& settings,
                                             const Inertia& inertia, const Load& load,
                                             double time_s, double dt_s, const RigidState& state,
                                             RigidState& next) noexcept;

}  // namespace fulcrum
