// A lesson in a window: hand and world on their threads, Lua, picture and sound here. A lesson that fails leaves the window
// up: the force has faded, a banner says where, and saving a mended file runs it again.
//
//   poll window -> lesson frame -> picture -> sound, 60 times a second
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/app/begin_help.h"
#include "runtime/app/choice_picture.h"
#include "runtime/app/desktop.h"
#include "runtime/app/lesson_input.h"
#include "runtime/app/lesson_pause.h"
#include "runtime/app/lesson_run.h"
#include "runtime/app/live_ear.h"
#include "runtime/app/live_loops.h"
#include "runtime/app/options.h"
#include "runtime/app/screen_trouble.h"
#include "runtime/app/stop_signal.h"
#include "runtime/app/watched_files.h"
#include "runtime/lesson/said_before.h"
#include "runtime/progress/store.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// How a screen was left.
enum class Left : std::uint8_t { to_menu, closed, time_is_up };

class LessonScreen {
  public:
    /// Everything given outlives the screen.
    LessonScreen(const Places& places, Desktop& desktop, ProgressStore& store,
                 const dialogue::Catalogue& catalogue, RunRequest request, const Options& options);
    ~LessonScreen();

    /// Plays until the learner leaves. Draws all the while, whatever the lesson does.
    Left play();
    /// True when the lesson failed and was not mended; then `play` has told why.
    [[nodiscard]] bool failed() const { return !error_.empty(); }
    /// True when something of what the learner did could not be kept.
    [[nodiscard]] bool lost_progress() const { return lost_progress_; }
    /// How the haptic loop did and how long after `since_s` of the monotonic clock it first ran, for the terminal.
    [[nodiscard]] std::string statistics(double since_s) const;

  private:
    void begin();
    [[nodiscard]] bool try_arm();
    void stop();
    void fail_with(const Error& error);
    void take_input(const WindowEvents& events);
    void take_orders();
    // One hand after the other, then none.
    [[nodiscard]] std::optional<std::size_t> next_why_hand() const {
        const std::size_t next = why_hand_ ? *why_hand_ + 1 : 0;
        return next < (run_ ? run_->hands().size() : 1) ? std::optional(next) : std::nullopt;
    }
    void say_again();
    void exchange();
    void listen();
    void watch_files();
    [[nodiscard]] View compose() const;
    [[nodiscard]] ScreenTrouble find_trouble() const;
    void show_hints(View& view) const;
    void save_wanted_screenshot(bool last_frame);

    const Places& places_;
    Desktop& desktop_;
    ProgressStore& store_;
    const dialogue::Catalogue& catalogue_;
    RunRequest request_;
    const Options& options_;

    std::unique_ptr<LessonRun> run_;
    LiveLoops loops_;
    double epoch_s_ = 0.0;
    int level_ = 0;
    double level_began_s_ = 0.0;
    std::optional<double> first_epoch_s_;  // of the first play
    double next_frame_s_ = 0.0;
    LessonPause pause_;
    bool lost_progress_ = false;
    std::string error_;  // the sentence of the failure, empty while all is well
    WatchedFiles files_;
    double next_watch_s_ = 0.0;

    SaidBefore said_before_;
    std::unique_ptr<LiveEar> ear_;  // null where the plan hears no microphone
    LessonInput input_{stop_signals_seen()};
    ChoicePictures pictures_;
    double polled_s_ = 0.0;  // when the window was asked last, monotonic clock
    std::optional<Left> left_;
    std::optional<std::size_t>
        why_hand_;  // whose force the panel explains that says why it is felt
    View last_view_{};
    bool screenshot_taken_ = false;
    int plays_ = 0;
};

}  // namespace fulcrum::runtime
