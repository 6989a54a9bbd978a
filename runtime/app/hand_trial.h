// Whether a hand's forces were tried for who holds it, and what becomes of a trial that was not good.
//
// Thread: load path.
#pragma once

#include "runtime/app/run_hand.h"
#include "runtime/app/run_request.h"
#include "runtime/lesson/first_use.h"
#include "runtime/progress/store.h"

#include <string>

namespace fulcrum::runtime {

/// Whether this hand's forces are to be tried first; `asked`: somebody will answer.
[[nodiscard]] bool needs_trial(const RunHand& hand, const RunRequest& request, bool asked);
/// What this learner's last trial found not good gives nothing until a new one is good, also where none is to be. A sentence for each.
[[nodiscard]] std::vector<std::string> withhold_refused(const RunHands& hands,
                                                        const RunRequest& request);
/// Keeps how it came out for the learner of that request and this hand's device; without force where it was not good, in this run.
/// `whose`: how the sentence that says so begins.
void take_trial(RunHand& hand, const std::string& whose, const FirstUse& trial, bool asked,
                const RunRequest& request, ProgressStore& store);

}  // namespace fulcrum::runtime
