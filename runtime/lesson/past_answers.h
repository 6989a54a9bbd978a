// What a learner has answered in earlier sessions, for a lesson that asks for it.
//
// Thread: load path.  Cost: reads what is kept of the learner; in proportion to the attempts.
#pragma once

#include "haptics/base/error.h"
#include "runtime/progress/store.h"
#include "runtime/scene/lesson_messages.h"

#include <cstdint>
#include <vector>

namespace fulcrum::runtime {

/// One entry a question of a lesson, those answered last at the end; the newest kMaxPastAnswers of them. Pure. A question is asked
/// anew where a session begins or its attempts are counted from 1 again.
[[nodiscard]] std::vector<PastAnswers> find_past_answers(const ProgressData& data,
                                                         const LearnerId& learner,
                                                         std::int64_t now_utc_ms);

/// Reads them; nothing of a store that keeps nothing.
[[nodiscard]] Expected<std::vector<PastAnswers>> read_past_answers(ProgressStore& store,
                                                                   const Learner& learner,
                                                                   std::int64_t now_utc_ms);

}  // namespace fulcrum::runtime
