#include "runtime/app/commands.h"
#include "runtime/app/desktop.h"
#include "runtime/app/felt_notes.h"
#include "runtime/app/force_trial.h"
#include "runtime/app/headless.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/lesson_run.h"
#include "runtime/app/lesson_screen.h"
#include "runtime/app/open_store.h"
#include "runtime/app/picture.h"
#include "runtime/app/run_request.h"
#include "runtime/app/run_told.h"
#include "runtime/app/stop_signal.h"
#include "runtime/lesson/learner_settings.h"

#include <cstdio>
#include <system_error>

namespace fulcrum::runtime {
namespace {

constexpr int kForcesDiffer = 3;
constexpr int kNotKept = 4;

// Of a run that went well. Nobody waits for what is kept of a guest.
int find_exit_code(const ProgressStore& store, const Options& options, bool lost_some) {
    const bool is_wanted = !options.learner.empty() || !options.database.empty();
    const bool is_kept = !lost_some && (store.keeps() || !is_wanted);
    const int interrupted = interrupt_exit_code();
    return interrupted != 0 || is_kept ? interrupted : kNotKept;
}

int run_in_window(const Installation& installation, const Options& options, RunRequest request) {
    auto desktop = Desktop::open(installation, options);
    if (!desktop) {
        return complain(desktop.error(), 2);
    }
    std::unique_ptr<DeskDriver> driver;
    if (!options.deeds.empty()) {
        auto opened = DeskDriver::open(options.deeds);
        if (!opened) {
            return complain(opened.error(), 2);
        }
        driver = std::move(*opened);
    }
    const auto store = open_store_beside_window(options.database);
    desktop->use(read_settings(*store, options.learner, desktop->usual).value_or(desktop->usual));
    while (true) {
        LessonScreen screen(installation.places, *desktop, *store, request, options);
        screen.play_by(driver.get());
        const Left left = screen.play();
        if (left == Left::entered && !screen.entered()->empty()) {
            Options other = options;
            other.lesson = *screen.entered();
            auto next = make_request(installation.places, other, true);
            if (!next) {
                return complain(next.error(), 2);
            }
            next->guest = request.guest;
            request = std::move(*next);
            continue;
        }
        say(screen.statistics(installation.started_s));
        return screen.failed() ? 1 : find_exit_code(*store, options, screen.lost_progress());
    }
}

// Writes the picture at the wanted time, or at the end.
class ScreenshotTaker {
  public:
    ScreenshotTaker(const Installation& installation, const Options& options, LessonRun& run,
                    const std::filesystem::path& folder)
        : installation_(installation), options_(options), run_(run), folder_(folder) {}

    void after_frame(double now_s) {
        if (!taken_ && options_.screenshot_at_s >= 0.0 && now_s >= options_.screenshot_at_s) {
            take();
        }
    }
    void at_end() {
        if (!taken_ && !options_.screenshot.empty()) {
            take();
        }
    }
    [[nodiscard]] bool failed() const { return failed_; }

  private:
    void take() {
        taken_ = true;
        const auto saved = save_screenshot(installation_.places, run_.description(), folder_,
                                           run_.view(installation_.catalogue), options_.screenshot);
        if (!saved) {
            failed_ = true;
            complain(saved.error(), 2);
        }
    }

    const Installation& installation_;
    const Options& options_;
    LessonRun& run_;
    std::filesystem::path folder_;
    bool taken_ = false;
    bool failed_ = false;
};

// Whether the forces of each hand were those of the record that was repeated; the exit code.
int tell_replay(const LessonRun& run) {
    int code = 0;
    for (std::size_t hand = 0; hand < run.hands().size(); ++hand) {
        if (const ReplayCheck* const check = run.replay_check(hand)) {
            std::printf("%s%s\n", hand == 0 ? "" : "The second hand: ", check->sentence().c_str());
            code = check->report().same() ? code : kForcesDiffer;
        }
    }
    return code;
}

int run_without_window(const Installation& installation, const Options& options,
                       const RunRequest& request) {
    const auto store = open_store_or_none(options.database);
    auto run = LessonRun::create(installation.places, request, *store, installation.catalogue);
    if (!run) {
        return complain_of_loading(run.error());
    }
    say_notices(**run);
    if (auto tried = try_forces(**run, request, *store); !tried) {
        return complain(tried.error(), 2);
    }
    ScreenshotTaker screenshot(installation, options, **run, request.folder);
    HeadlessSettings settings;
    settings.end_s = options.seconds ? options.seconds : (*run)->replay_end_s();
    settings.shows_talk = true;
    const auto desk = seat_player(**run, request);
    settings.desk = desk.get();
    if (!options.screenshot.empty()) {
        settings.after_frame = [&](double now_s) { screenshot.after_frame(now_s); };
    }
    const auto outcome =
        request.plan.live ? run_in_real_time(**run, settings) : run_headless(**run, settings);
    const auto recorded = (*run)->finish_record();
    say_losses(**run);
    if (!outcome) {
        return complain(outcome.error(), 1);
    }
    if (!recorded) {
        return complain(recorded.error(), 2);
    }
    say(outcome->pace);
    screenshot.at_end();
    (*run)->session().end(EndReason::left);
    const std::string& unkept = (*run)->session().store_trouble();
    say(unkept);
    const SessionResult& result = (*run)->session().result();
    std::printf("%s: %s after %.1f s (%.0f times real time), score %d, %d of 3 stars, %d %s.\n",
                (*run)->description().id.c_str(), outcome->finished ? "finished" : "ended",
                outcome->simulated_s,
                outcome->wall_s > 0.0 ? outcome->simulated_s / outcome->wall_s : 0.0, result.score,
                result.stars, result.attempts, result.attempts == 1 ? "answer" : "answers");
    if (outcome->interrupted) {
        std::fprintf(stderr, "Ended by a signal; what there is of the run is kept.\n");
    }
    tell_felt(felt_times_of((*run)->hands()), (*run)->description().id);
    say(unsaid_of(**run, *outcome));
    if (const std::string trouble = trouble_of(**run, *outcome, true); !trouble.empty()) {
        say(trouble);
        return 1;
    }
    if (screenshot.failed()) {
        return 2;
    }
    const int differs = tell_replay(**run);
    return differs != 0 ? differs : find_exit_code(*store, options, !unkept.empty());
}

}  // namespace

int run_command(const Installation& installation, const Options& options) {
    watch_for_stop_signal();
    const bool in_window = !options.headless && display_available();
    auto request = make_request(installation.places, options, in_window);
    if (!request) {
        return complain(request.error(), 2);
    }
    if (!options.headless && !in_window) {
        std::fprintf(stderr, "There is no display, so the lesson runs without a window%s.\n",
                     keeps_time(*request) ? "" : ", with the simulated hand");
    }
    return in_window ? run_in_window(installation, options, std::move(*request))
                     : run_without_window(installation, options, *request);
}

}  // namespace fulcrum::runtime
