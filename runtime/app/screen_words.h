// What a lesson's screen says besides the lesson: in and above the line to type in, and what is wrong.
//
// Thread: that of the window.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/app/glosses.h"
#include "runtime/app/lesson_input.h"
#include "runtime/app/screen_trouble.h"

#include <string>

namespace fulcrum::runtime {

/// Choices, and what else there is before anything is typed. `next`: the title of the lesson that may be chosen at the end.
void show_answer_line(const LessonInput& input, const std::string& next,
                      const dialogue::Catalogue& catalogue, View& view);

/// What helps where nothing else is said: `before` was said before, or where it has begun how to move. Who looks back, pauses or has asked
/// for help sees what the words are in the language of the window.
void show_hints(const LessonRun& run, const RunRequest& request, const std::string& before,
                bool has_begun, bool paused, Glosses& glosses, View& view);

/// Of a screen with this play, or none, and this failure.
[[nodiscard]] ScreenTrouble find_trouble(const LessonRun* run, const LessonInput& input,
                                         const std::string& error);

}  // namespace fulcrum::runtime
