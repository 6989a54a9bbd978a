// How far what the device was sent is off for each knob of a plan (knobs.h): the run's tape once more as it was, and beside it once for each
// knob with that one converged; round by round
//
//   e_k = |F_converged - F_run|      in the world, N; of torques likewise, N m; of a reference with n parts a round n times, F_run held
// The run once more must give what it gave, to the bit: else nothing is said, but why.
// A reference that moves a world, or turns a body on a hinge, may leave the run's way: then the bodies are elsewhere, and that counts.
//
// Thread: that of the command. Cost: a round of each loop for each round of the tape and knob.
#pragma once

#include "runtime/app/run_tape.h"
#include "runtime/scene/analysis.h"
#include "runtime/scene/knobs.h"

#include <functional>
#include <vector>

namespace fulcrum::runtime {

/// Plans a changed lesson.
using PlanAnew = std::function<Expected<Plan>(const std::function<void(LessonDescription&)>&)>;

/// Of each knob, in their order. `plan` is that of the tape's run, `first` what its world was told before the first frame; `plan_anew` is asked
/// for knobs that change the lesson alone.
[[nodiscard]] std::vector<KnobError> measure_knobs(const RunTape& tape, const Plan& plan,
                                                   const std::vector<WorldCommand>& first,
                                                   const std::vector<Knob>& knobs,
                                                   const PlanAnew& plan_anew = {});

/// Between two answers, `share` of the way, 0 to 1, to the second; stamped `now_s`. Exact for a hand that goes evenly in a force that is
/// quadratic in place and velocity.
[[nodiscard]] LinearisedWrench blend_answers(const LinearisedWrench& before,
                                             const LinearisedWrench& behind, double share,
                                             double now_s) noexcept;

}  // namespace fulcrum::runtime
