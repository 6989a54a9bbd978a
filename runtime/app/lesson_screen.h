// A lesson in a window: hand and world on their threads, Lua, picture and sound here. A lesson that fails leaves the window
// up: the force has faded, a banner says where, and saving a mended file runs it again.
//
//   poll window -> lesson frame -> picture -> sound, 60 times a second
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/app/begin_help.h"
#include "runtime/app/choice_picture.h"
#include "runtime/app/desk_driver.h"
#include "runtime/app/desktop.h"
#include "runtime/app/glosses.h"
#include "runtime/app/lesson_input.h"
#include "runtime/app/lesson_pause.h"
#include "runtime/app/lesson_run.h"
#include "runtime/app/live_ear.h"
#include "runtime/app/live_loops.h"
#include "runtime/app/options.h"
#include "runtime/app/screen_trouble.h"
#include "runtime/app/settings_page.h"
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
enum class Left : std::uint8_t { to_menu, closed, time_is_up, entered };

class LessonScreen {
  public:
    /// Everything given outlives the screen.
    LessonScreen(const Places& places, Desktop& desktop, ProgressStore& store, RunRequest request,
                 const Options& options);
    ~LessonScreen();

    /// A simulated player plays, in the window too; it outlives the screen.
    void play_by(DeskDriver* driver) { driver_ = driver; }
    /// Plays until the learner leaves. Draws all the while, whatever the lesson does.
    Left play();
    /// Of a room that was left for another lesson: its name, empty for the list of all.
    [[nodiscard]] const std::optional<std::string>& entered() const { return entered_; }
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
    void open_settings();
    void take_settings(const WindowEvents& events);
    // One hand after the other, then none.
    [[nodiscard]] std::optional<std::size_t> next_why_hand() const {
        const std::size_t next = why_hand_ ? *why_hand_ + 1 : 0;
        return next < (run_ ? run_->hands().size() : 1) ? std::optional(next) : std::nullopt;
    }
    void say_again();
    void exchange();
    [[nodiscard]] Expected<void> drive(double now_s);
    void listen();
    void watch_files();
    [[nodiscard]] View compose() const;
    void save_wanted_screenshot(bool last_frame);

    const Places& places_;
    Desktop& desktop_;
    ProgressStore& store_;
    const dialogue::Catalogue& catalogue_;  // the window's
    mutable Glosses glosses_;               // it reads where the language has changed
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

    SaidBefore said_before_;
    std::unique_ptr<LiveEar> ear_;  // null where the plan hears no microphone
    LessonInput input_{stop_signals_seen()};
    DeskDriver* driver_ = nullptr;  // null where a person plays
    ChoicePictures pictures_;
    std::optional<SettingsPage> settings_;  // while they are open
    double polled_s_ = 0.0;                 // when the window was asked last, monotonic clock
    std::optional<Left> left_;
    std::optional<std::string> entered_{};
    std::optional<KnownLesson> next_;  // what may be played when this is over
    int best_before_ = -1;             // the learner's most stars in it before this play
    std::optional<std::size_t>
        why_hand_;  // whose force the panel explains that says why it is felt
    View last_view_{};
    bool screenshot_taken_ = false;
    int plays_ = 0;
};

}  // namespace fulcrum::runtime
