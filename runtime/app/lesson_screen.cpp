#include "runtime/app/lesson_screen.h"

#include "haptics/base/clock.h"
#include "runtime/app/force_trial.h"
#include "runtime/app/installation.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/lesson_cards.h"
#include "runtime/app/run_told.h"
#include "runtime/app/screen_words.h"
#include "runtime/audio/openal/openal_microphone.h"
#include "runtime/lesson/end_words.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <system_error>

namespace fulcrum::runtime {
namespace fs = std::filesystem;

namespace {

constexpr double kStorePatience_s = 15.0;    // for the disk, when a play is over
constexpr double kHelp_s = 15.0;             // how long the first level says how to move
constexpr double kLongestStep_s = 0.1;       // of keys that are held, when the program stood still
constexpr double kAnswerPatience_s = 0.004;  // for Lua, before a frame shows what there is

}  // namespace

LessonScreen::LessonScreen(const Places& places, Desktop& desktop, ProgressStore& store,
                           RunRequest request, const Options& options)
    : places_(places),
      desktop_(desktop),
      store_(store),
      catalogue_(desktop.words->shown()),
      glosses_(*desktop.words, request.folder),
      request_(std::move(request)),
      options_(options),
      next_(find_next_lesson(request_.lessons, request_.folder.filename())) {
    input_.offer_next(next_.has_value());
}

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
    auto run = LessonRun::create(places_, request, store_, desktop_.words->english());
    if (!run) {
        if (!interrupted()) {
            fail_with(run.error());
        }
        return;
    }
    run_ = std::move(*run);
    best_before_ = best_in(read_best_stars(store_, request_.player()), run_->description().id);
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
    if (driver_ != nullptr) {
        driver_->begin(*run_, request_.by, request_.seed,
                       {desktop_.window->width_px(), desktop_.window->height_px()});
    }
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
        if (driver_ != nullptr) {
            driver_->leave();
        }
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
        desktop_.read_choice(last_view_, input_.chosen(), input_.pointer_px());
        desktop_.finish_frame();
        if (run_ && run_->session().result().entered) {
            entered_ = run_->session().result().entered;
            left_ = Left::entered;
        }
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
    if (settings_) {
        return take_settings(events);
    }
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
    input_.take(events, !run_ || offers_another_begin(find_trouble(run_.get(), input_, error_)),
                size, dt_s);
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
            case ScreenOrder::play_next:
                entered_ = next_->name;
                left_ = Left::entered;
                break;
            case ScreenOrder::open_settings:
                open_settings();
                break;
            case ScreenOrder::switch_why:
                why_hand_ = next_why_hand();
                break;
        }
    }
}

// The lesson is paused meanwhile.
void LessonScreen::open_settings() {
    input_.lay_aside(true);
    settings_.emplace(desktop_, store_, catalogue_, request_.learner);
}

void LessonScreen::take_settings(const WindowEvents& events) {
    if (!settings_->take(events)) {
        settings_.reset();
        input_.lay_aside(false);
    }
    const bool left_handed = desktop_.settings.left_handed();
    if (run_ && desktop_.may_set(SettingKind::hand) && run_->left_handed() != left_handed) {
        request_.fit.left_handed = left_handed;
        input_.hold_by(left_handed);
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
        return run_ ? run_->keep_rounds() : void();
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
            drive(now_s)
                .and_then([&] { return input_.take_frame(now_s, pause_.stood_s()); })
                .and_then([&](const FrameInput& input) { return run_->begin_frame(input); });
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
        desktop_.picture->load_models(pictures_.models(), request_.folder);
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

// What a simulated player does now; what comes of it the window tells later.
Expected<void> LessonScreen::drive(double now_s) {
    const auto find = [&](int spot) { return desktop_.picture->place_of(spot); };
    return driver_ == nullptr ? Expected<void>() : driver_->act(input_, now_s, find);
}

// A lesson that failed runs again as soon as one of its files is saved; with --watch a running one does too.
void LessonScreen::watch_files() {
    if ((options_.watch || !error_.empty()) && files_.changed_by(monotonic_now_s())) {
        begin();
    }
}

View LessonScreen::compose() const {
    if (settings_) {
        return settings_->view();
    }
    View view = run_ ? run_->view(catalogue_, desktop_.settings.calm()) : last_view_;
    if (run_) {
        input_.show(view);
        pictures_.show(view);
        view.why = why_hand_ ? run_->why().show(*why_hand_, catalogue_) : ViewWhy{};
    }
    if (ear_) {
        ear_->show(view, catalogue_);
    }
    if (input_.ended()) {
        view.end_note = explain_stars(run_->session().result(), best_before_, catalogue_);
    }
    show_answer_line(input_, next_ ? next_->title : std::string(), catalogue_, view);
    show(find_trouble(run_.get(), input_, error_), catalogue_, view);
    if (run_ && error_.empty()) {
        const bool has_begun = level_ <= 1 && monotonic_now_s() - level_began_s_ < kHelp_s;
        show_hints(*run_, request_, said_before_.shown(monotonic_now_s()), has_begun,
                   input_.paused(), glosses_, view);
        view.paused = input_.stopped();
        view.buttons = find_buttons(*run_, view.paused);
        view.speaks = desktop_.speaks();
    }
    return view;
}

void LessonScreen::save_wanted_screenshot(bool last_frame) {
    if (options_.screenshot.empty() || !run_) {
        return;
    }
    const bool at_time =
        options_.screenshot_at_s >= 0.0 && monotonic_now_s() - epoch_s_ >= options_.screenshot_at_s;
    if ((last_frame || at_time) && !screenshot_taken_) {
        screenshot_taken_ = true;
        say(desktop_.keep_picture(last_view_, options_.screenshot));
    }
}

std::string LessonScreen::statistics(double since_s) const {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), " The first round came %.2f s after the start; ",
                  first_epoch_s_.value_or(since_s) - since_s);
    return loops_.describe_pace() + text.data() + describe(desktop_.picture->shown());
}

}  // namespace fulcrum::runtime
