// Says what runs for a lesson: each stage with its rate, its memory and the line of the lesson that
// asked for it; and, once it has been played, what each stage cost.
#pragma once

#include "runtime/scene/analysis.h"
#include "runtime/scene/plan.h"

#include <string>

namespace fulcrum::runtime {

/// A table for people, 100 columns at most, one stage a line, in the order of the data; then how hard, rough and slippery each
/// material of the lesson is, in the words that an answer may say, and what else a teacher should know.
[[nodiscard]] std::string explain(const LessonDescription& lesson, const Plan& plan);

/// The same width: calls, median and 99 % time, share and memory of each stage that was timed, then errors.
[[nodiscard]] std::string explain_costs(const Plan& plan, const Analysis& analysis);

/// Both as JSON, one object; `analysis` may be null. runtime/README.md describes it.
[[nodiscard]] std::string explain_json(const LessonDescription& lesson, const Plan& plan,
                                       const Analysis* analysis);

}  // namespace fulcrum::runtime
