// Says what runs for a lesson: each stage with its rate, its memory and the line of the lesson that
// asked for it.
#pragma once

#include "runtime/scene/plan.h"

#include <string>

namespace fulcrum::runtime {

/// A table for people, 100 columns at most, one stage a line, in the order of the data.
[[nodiscard]] std::string explain(const LessonDescription& lesson, const Plan& plan);

/// Bytes as people read them: "96 B", "1.5 kB", "2.0 MB".
[[nodiscard]] std::string bytes_text(std::size_t bytes);

}  // namespace fulcrum::runtime
