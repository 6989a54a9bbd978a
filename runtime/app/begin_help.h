// What a level's beginning says to who sees it for the first time: how the hand is moved, what else can be asked, and what is softer in this hand
// than it is.
//
// Thread: the lesson's. Cost: builds a sentence.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/app/lesson_run.h"
#include "runtime/scene/view.h"

#include <span>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Who moves the hands, and what they may ask.
struct BeginHelp {
    bool has_mouse = false, has_keys = false, has_stick = false, has_cap = false;
    bool has_reel = false;  ///< a kite flies
    std::string keys{};     ///< that move it, as they are labelled
    bool may_ask = false, tells_why = false;
    std::span<const std::string> softer{};  ///< what a device that pushes would shake with as it is
};

/// Of a run that was asked for so; both outlive it.
[[nodiscard]] BeginHelp find_begin_help(const LessonRun& run, const RunRequest& request);
/// What the screen's corner offers to who has a mouse alone; in a pause to leave as well.
[[nodiscard]] std::vector<ScreenButton> find_buttons(const LessonRun& run, bool paused);

/// Empty where there is nothing to say.
[[nodiscard]] std::string say_begin_help(const BeginHelp& help,
                                         const dialogue::Catalogue& catalogue);

}  // namespace fulcrum::runtime
