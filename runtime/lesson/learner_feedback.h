// The ladder of feedback that a teacher has chosen for one learner, kept with the session for which it was given: the newest counts
// the next time, for every lesson. "lesson" takes it back.
//
// Thread: that of the run.  Cost: one reading of the learner's progress.
#pragma once

#include "dialogue/marking/feedback_ladder.h"
#include "runtime/progress/store.h"

#include <string>

namespace fulcrum::runtime {

inline constexpr const char* kFeedback = "feedback";    ///< the session's setting
inline constexpr const char* kAsLessonSays = "lesson";  ///< its value, where none is chosen

/// "recast,rule"; "lesson" for an empty one.
[[nodiscard]] std::string feedback_text(const dialogue::FeedbackLadder& ladder);
/// The learner's newest one; empty, as each lesson says, where none is kept that could be one.
[[nodiscard]] dialogue::FeedbackLadder find_feedback(const ProgressData& data,
                                                     const LearnerId& learner);
/// The same from a store; empty where it cannot be read.
[[nodiscard]] dialogue::FeedbackLadder read_feedback(ProgressStore& store, const Learner& learner);

}  // namespace fulcrum::runtime
