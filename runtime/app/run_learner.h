// Who learns in a run, and what is known of them from before.
//
// Thread: load path; waits for the store.
#pragma once

#include "runtime/app/run_request.h"
#include "runtime/lesson/past_answers.h"
#include "runtime/progress/store.h"
#include "runtime/scene/plan.h"

#include <vector>

namespace fulcrum::runtime {

struct RunLearner {
    LearnerId id{};
    bool is_known = false;          ///< somebody who was named, and a person
    std::vector<PastAnswers> past;  ///< in earlier sessions, where the lesson asks for it
};

/// Enrols who was named, else a guest; whoever hears gets the learner's throat, where it is known.
[[nodiscard]] Expected<RunLearner> find_learner(const RunRequest& request, bool wants_past,
                                                ProgressStore& store, Plan& plan);

}  // namespace fulcrum::runtime
