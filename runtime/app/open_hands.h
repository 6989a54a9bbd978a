// The hands of a run, each with its device as that stands before the learner, and the plan fitted to what they can give and reach.
//
// Thread: load path; waits for devices.
#pragma once

#include "runtime/app/run_hand.h"
#include "runtime/app/run_plan.h"
#include "runtime/progress/store.h"

namespace fulcrum::runtime {

/// As many as are planned; the request has been settled.
[[nodiscard]] Expected<void> open_hands(const RunOrder& order, ProgressStore& store, RunPlan& plan,
                                        RunHands& hands);

}  // namespace fulcrum::runtime
