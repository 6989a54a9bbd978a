// Lesson, world and sound of touch stand still while somebody has paused or stopped; the hands' own loops go on, without force.
//
// Thread: that of the window.
#pragma once

#include "runtime/app/desktop.h"
#include "runtime/app/live_loops.h"

#include <optional>

namespace fulcrum::runtime {

class LessonPause {
  public:
    /// Once a frame, at `now_s` of the loops' clock. An error where the effects' loops cannot start again.
    [[nodiscard]] Expected<void> take(bool is_stopped, double now_s, LessonRun& run,
                                      LiveLoops& loops, Desktop& desktop);
    [[nodiscard]] bool stands() const { return since_s_.has_value(); }
    /// Before it stands now, in all.
    [[nodiscard]] double stood_s() const { return stood_s_; }

  private:
    std::optional<double> since_s_;
    double stood_s_ = 0.0;
};

}  // namespace fulcrum::runtime
