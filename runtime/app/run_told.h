// What a run tells a person at the terminal.
#pragma once

#include "runtime/app/lesson_run.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// What got lost between the loops, a sentence each; none in a good run. While the loops stand still.
[[nodiscard]] std::vector<std::string> find_losses(LessonRun& run);

/// What a lesson's print() said, on the terminal, at once.
void print_lines(const std::vector<std::string>& lines);
/// What a teacher should know of the scene before it is played, on the terminal.
void say_notices(const LessonRun& run);
/// What got lost in a run, likewise.
void say_losses(LessonRun& run);

}  // namespace fulcrum::runtime
