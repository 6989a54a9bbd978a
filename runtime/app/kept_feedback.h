// The ladder of feedback that a run begins with, where nobody says one: that of the run that is repeated, else the learner's own.
//
// Thread: that of the run.  Cost: one reading of the learner's progress.
#pragma once

#include "runtime/app/run_request.h"
#include "runtime/progress/store.h"

namespace fulcrum::runtime {

/// The request with it; a guest and a simulated pupil have none of their own.
[[nodiscard]] RunRequest with_kept_feedback(RunRequest request, ProgressStore& store);

}  // namespace fulcrum::runtime
