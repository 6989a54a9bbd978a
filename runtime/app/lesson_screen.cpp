#include "runtime/app/lesson_screen.h"

#include "haptics/base/clock.h"
#include "runtime/app/force_trial.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/run_told.h"
#include "runtime/audio/openal/openal_microphone.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <system_error>

namespace fulcrum::runtime {
namespace fs = std::filesystem;

namespace {

constexpr double kWatchPeriod_s = 0.25;  // how often the lesson's files are looked at
// For what the disk still has to keep when a play is over.
constexpr double kStorePatience_s = 15.0;
constexpr double kHelp_s = 15.0;        // how long the first level says how to move
constexpr double kLongestStep_s = 0.1;  // of keys that are held, when the program stood still
// A frame waits so long for Lua before it shows what there is.
constexpr double kAnswerPatience_s = 0.004;

void say(const std::string& sentence) {
    if (!sentence.empty()) {
        std::fprintf(stderr, "%s\n", sentence.c_str());
    }
}

void say_all(const std::vector<std::string>& sentences) {
    std::ranges::for_each(sentences, say);
}

}  // namespace

LessonScreen::LessonScreen(const Places& places, Desktop& desktop, ProgressStore& store,
                           const dialogue::Catalogue& catalogue, RunRequest request,
                           const Options& options)
    : places_(places),
      desktop_(desktop),
      store_(store),
      catalogue_(catalogue),
      request_(std::move(request)),
      options_(options) {}

LessonScreen::~LessonScreen() {
    stop();
}

// Starts the lesson afresh: process, plan, loops. What was there before is gone first.
void LessonScreen::begin() {
    stop();
    error_.clear();
    said_before_ = {};
    files_.watch_folder(request_.folder);
    RunRequest request = request_;
    if (++plays_ > 1 && !request.record_file.empty()) {
        request.record_file += "." + std::to_string(plays_);  // an earlier play's record is kept
    }
    auto run = LessonRun::create(places_, request, store_, catalogue_);
    if (!run) {
        if (!interrupted()) {
            fail_with(run.error());
        }
        return;
    }
    run_ = std::move(*run);
    print_lines(run_->process().prints_while_loading());
    say_notices(*run_);
    files_.watch_only(files_of_lesson(places_, request_.folder, run_->description(),
                                      run_->process().files_read()));
    say_all(desktop_.picture->load_lesson(run_->description(), request_.folder));
    (void)desktop_.picture->take_notices();  // of other lessons, which the list has shown
    if (desktop_.sound) {
        desktop_.sound->set_stream(run_->effects().touch_sound());
    }
    if (run_->plan().microphone) {
        ear_ = std::make_unique<LiveEar>(run_->plan().hearing.listen, microphone_opener());
    }
    if (!try_arm()) {
        return;
    }
    input_.begin(run_.get());
    set_stop_target(&run_->channels().emergency_stop);
    epoch_s_ = level_began_s_ = monotonic_now_s();
    level_ = 0;
    first_epoch_s_ = first_epoch_s_.value_or(epoch_s_);
    next_frame_s_ = 0.0;
    pause_ = {};
    if (auto started = loops_.start(*run_, epoch_s_); !started) {
        fail_with(started.error());
    }
}

// False where the learner left instead.
bool LessonScreen::try_arm() {
    const auto end_s =
        options_.seconds ? std::optional(monotonic_now_s() + *options_.seconds) : std::nullopt;
    const auto tried = try_forces_in_window(*run_, request_, store_, desktop_, catalogue_, end_s);
    if (!tried) {
        fail_with(tried.error());
    } else if (*tried != TrialLeft::done) {
        left_ = *tried == TrialLeft::to_menu  ? Left::to_menu
                : *tried == TrialLeft::closed ? Left::closed
                                              : Left::time_is_up;
    }
    return tried && *tried == TrialLeft::done;
}

void LessonScreen::stop() {
    // A loop that ends leaves its device without force at once; so the force fades first.
    if (run_ && loops_.haptic_status().running) {
        run_->end_softly();
        std::this_thread::sleep_for(std::chrono::duration<double>(run_->fade_shown_s()));
    }
    loops_.stop();
    set_stop_target(nullptr);
    ear_.reset();
    if (desktop_.sound) {
        desktop_.sound->set_stream(nullptr);
    }
    if (run_) {
        // No hand feels anything now, so this may wait for the disk.
        run_->session().end(EndReason::left);
        run_->session().settle(kStorePatience_s);
        lost_progress_ = lost_progress_ || !run_->session().store_trouble().empty();
        say(run_->session().store_trouble());
        if (auto kept = run_->finish_record(); !kept) {
            say(to_sentence(kept.error()));
        }
        say_losses(*run_);
        input_.begin(nullptr);
        run_.reset();
    }
}

// The force fades first, on the haptic thread; only then is anything said.
void LessonScreen::fail_with(const Error& error) {
    error_ = to_sentence(error);
    desktop_.hush();
    if (run_) {
        run_->fail_softly(error_);
    }
    say(error_);
}

Left LessonScreen::play() {
    const double opened_s = monotonic_now_s();
    begin();
    while (!left_) {
        take_input(desktop_.window->poll());
        listen();
        exchange();
        watch_files();
        last_view_ = compose();
        desktop_.picture->show(last_view_);
        say_all(desktop_.picture->take_notices());
        // A lesson that could not begin has its time too, or a script would wait for it for ever.
        const double since_s = run_ ? epoch_s_ : opened_s;
        const bool time_is_up =
            options_.seconds && monotonic_now_s() - since_s >= *options_.seconds;
        save_wanted_screenshot(time_is_up);
        if (desktop_.sound) {
            const bool unfelt = run_ && !renders_force(run_->hands());
            desktop_.sound->set_force_sound(
                unfelt && error_.empty() ? last_view_.force.force_W.norm() : 0.0);
        }
        desktop_.finish_frame();
        if (time_is_up) {
            left_ = Left::time_is_up;
        }
    }
    desktop_.fall_silent();
    return *left_;
}

void LessonScreen::take_input(const WindowEvents& events) {
    if (events.close || interrupted()) {
        left_ = Left::closed;
    }
    input_.hear_stops(stop_signals_seen());
    if (ear_ && ear_->take_keys(events)) {
        desktop_.hush();
    }
    if (events.button_press[0] && run_ && error_.empty()) {
        if (const auto spot = desktop_.picture->spot_at(events.press_x_px, events.press_y_px)) {
            spot->button ? input_.press(*spot->button) : input_.pick(spot->choice, spot->said);
        }
    }
    const double now_s = monotonic_now_s();
    const double dt_s = std::clamp(now_s - polled_s_, 0.0, kLongestStep_s);
    polled_s_ = now_s;
    const PictureSize size{desktop_.window->width_px(), desktop_.window->height_px()};
    input_.take(events, !run_ || offers_another_begin(find_trouble()), size, dt_s);
    take_orders();
}

void LessonScreen::take_orders() {
    for (const ScreenOrder order : input_.take_orders()) {
        switch (order) {
            case ScreenOrder::begin_again:
                begin();
                return;
            case ScreenOrder::leave:
                left_ = Left::to_menu;
                break;
            case ScreenOrder::switch_fullscreen:
                desktop_.window->set_fullscreen(!desktop_.window->fullscreen());
                break;
            case ScreenOrder::say_again:
                say_again();
                break;
            case ScreenOrder::switch_why:
                why_hand_ = next_why_hand();
                break;
        }
    }
}

// What stands there; pressed again, what was said before that.
void LessonScreen::say_again() {
    std::vector<std::string> standing;
    for (const std::string& text :
         {run_->session().hud().feedback, run_->session().hud().caption}) {
        if (!text.empty()) {
            standing.push_back(text);
        }
    }
    desktop_.say_again(said_before_.look_back(standing, monotonic_now_s()));
}

// What the learner says while somebody listens; never what the program says itself.
void LessonScreen::listen() {
    if (!ear_) {
        return;
    }
    const bool wanted = error_.empty() && !input_.stopped() && run_->session().listens();
    if (const auto utterance = ear_->step(wanted, desktop_.speaks())) {
        run_->session().hear_utterance(*utterance);
    }
    say(ear_->take_trouble());
}

// One frame of the lesson, without ever waiting long for it: the picture goes on even when Lua hangs.
void LessonScreen::exchange() {
    if (!run_ || !error_.empty()) {
        return;
    }
    say(take_device_notice(run_->hands()));
    const double now_s = monotonic_now_s() - epoch_s_;
    if (auto stood = pause_.take(input_.stands_still(), now_s, *run_, loops_, desktop_); !stood) {
        fail_with(stood.error());
        return;
    }
    if (pause_.stands()) {
        run_->keep_rounds();
    }
    if (!run_->process().waits_for_reply() && now_s >= next_frame_s_ && !pause_.stands()) {
        const auto sent =
            input_.take_frame(now_s, pause_.stood_s()).and_then([&](const FrameInput& input) {
                return run_->begin_frame(input);
            });
        if (!sent) {
            fail_with(sent.error());
            return;
        }
        next_frame_s_ =
            std::max(next_frame_s_ + 1.0 / run_->plan().haptic.lesson_rate_hz, now_s - 0.1);
    }
    const double give_up_s = monotonic_now_s() + kAnswerPatience_s;
    std::optional<Expected<FrameReport>> report;
    while (run_->process().waits_for_reply() && !(report = run_->poll_frame()) &&
           monotonic_now_s() < give_up_s) {
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    if (!report) {
        return;
    }
    if (!*report) {
        fail_with(report->error());
        return;
    }
    input_.look_again();
    if (pictures_.look(input_.choices(), run_->description(), places_, request_.folder)) {
        desktop_.picture->load_models(pictures_.names(), request_.folder);
    }
    desktop_.play((*report)->sounds);
    desktop_.say((*report)->spoken);
    for (const std::string& text : (*report)->spoken) {
        said_before_.add(text);
    }
    print_lines((*report)->printed);
    if (const int level = run_->session().hud().level; level != level_) {
        level_ = level;
        level_began_s_ = monotonic_now_s();
    }
}

// A lesson that failed runs again as soon as one of its files is saved; with --watch a running one does too.
void LessonScreen::watch_files() {
    const double now_s = monotonic_now_s();
    const bool looks = options_.watch || !error_.empty();
    if (!looks || now_s < next_watch_s_) {
        return;
    }
    next_watch_s_ = now_s + kWatchPeriod_s;
    if (files_.changed()) {
        begin();
    }
}

View LessonScreen::compose() const {
    View view = run_ ? run_->view(catalogue_) : last_view_;
    if (run_) {
        input_.show(view);
        pictures_.show(view);
        view.why = why_hand_ ? run_->why().show(*why_hand_, catalogue_) : ViewWhy{};
    }
    if (ear_) {
        ear_->show(view, catalogue_);
    }
    // Before anything is typed the line says what else there is.
    if (input_.ended()) {
        view.choices = {{catalogue_.say("end.play_again"), {}}, {catalogue_.say("end.menu"), {}}};
    } else if (!view.choices.empty()) {
        view.microphone.words = catalogue_.say("hud.choose_here");
    } else if (input_.asking()) {
        view.microphone.words = catalogue_.say("hud.ask_here");
    } else if (view.input_visible && view.microphone.words.empty()) {
        view.microphone.words = catalogue_.say("hud.type_here");
    }
    show(find_trouble(), catalogue_, view);
    if (run_ && error_.empty()) {
        show_hints(view);
        view.paused = input_.stopped();
        view.buttons = find_buttons(*run_);
    }
    return view;
}

ScreenTrouble LessonScreen::find_trouble() const {
    ScreenTrouble trouble;
    trouble.error = error_;
    trouble.is_stopped = input_.stopped();
    trouble.is_paused = input_.paused();
    if (run_) {
        trouble.waited_s = run_->process().waited_s();
        trouble.device_is_lost = device_is_lost(run_->hands());
        trouble.is_unkept = !run_->session().store_trouble().empty();
        trouble.holds_back = holds_back(run_->hands(), run_->plan());
    }
    return trouble;
}

// What helps where nothing else is said.
void LessonScreen::show_hints(View& view) const {
    const std::string before = said_before_.shown(monotonic_now_s());
    if (view.banner.empty() && !before.empty()) {
        view.banner = catalogue_.say("hud.said_before", {{"text", before}});
    }
    const bool is_begun = monotonic_now_s() - level_began_s_ < kHelp_s;
    if (view.banner.empty() && is_begun && level_ <= 1 && !run_->session().result().finished) {
        view.banner = say_begin_help(find_begin_help(*run_, request_), catalogue_);
    }
}

void LessonScreen::save_wanted_screenshot(bool last_frame) {
    if (options_.screenshot.empty() || !run_) {
        return;
    }
    const bool at_time =
        options_.screenshot_at_s >= 0.0 && monotonic_now_s() - epoch_s_ >= options_.screenshot_at_s;
    if ((last_frame || at_time) && !screenshot_taken_) {
        screenshot_taken_ = true;
        const Image seen = desktop_.picture->show_and_read(last_view_);
        if (auto kept = save_png(options_.screenshot, seen); !kept) {
            say(to_sentence(kept.error()));
        }
    }
}

std::string LessonScreen::statistics(double since_s) const {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(),
                  " The first round came %.2f s after the start; %llu pictures.",
                  first_epoch_s_.value_or(since_s) - since_s,
                  static_cast<unsigned long long>(desktop_.picture->n_shown()));
    return loops_.describe_pace() + text.data();
}

}  // namespace fulcrum::runtime
