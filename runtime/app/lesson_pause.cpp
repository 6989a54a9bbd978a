#include "runtime/app/lesson_pause.h"

namespace fulcrum::runtime {

Expected<void> LessonPause::take(bool is_stopped, double now_s, LessonRun& run, LiveLoops& loops,
                                 Desktop& desktop) {
    if (is_stopped == stands()) {
        return {};
    }
    if (desktop.sound) {
        desktop.sound->set_stream(is_stopped ? nullptr : run.effects().touch_sound());
    }
    if (is_stopped) {
        desktop.hush();
        loops.stand_still();
        since_s_ = now_s;
        return {};
    }
    stood_s_ += now_s - *since_s_;
    since_s_.reset();
    return loops.go_on(run);
}

}  // namespace fulcrum::runtime
