// Who learns in a run, and what is known of them from before.
//
// Thread: load path; waits for the store.
#pragma once

#include "runtime/app/run_plan.h"
#include "runtime/lesson/session_messages.h"
#include "runtime/progress/store.h"
#include "runtime/scene/plan.h"

namespace fulcrum::runtime {

struct RunLearner {
    LearnerId id{};
    bool is_known = false;  ///< somebody who was named, and a person
    KnownAtFirst known{};   ///< what the lesson asks for
};

/// Enrols who was named, else a guest; whoever hears gets the learner's throat, where it is known. Of a room nobody is enrolled: it knows the
/// lessons that are here, and how its learner did in them.
[[nodiscard]] Expected<RunLearner> find_learner(const RunOrder& order,
                                                const LessonDescription& lesson,
                                                ProgressStore& store, Plan& plan);

}  // namespace fulcrum::runtime
