// The first use of an arm or a joystick as a learner sees it. See force_trial.h.
#include "dialogue/unicode.h"
#include "haptics/base/clock.h"
#include "runtime/app/force_trial.h"
#include "runtime/app/hand_trial.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/stop_keys.h"
#include "runtime/app/stop_signal.h"
#include "runtime/app/typing.h"
#include "runtime/scene/choice_columns.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace fulcrum::runtime {
namespace {

class TrialScreen {
  public:
    TrialScreen(ForceTrial& trial, Desktop& desktop, const dialogue::Catalogue& words,
                bool is_second)
        : trial_(trial), desktop_(desktop), words_(words), is_second_(is_second) {
        stop_.watch(&trial.channels());
        desktop_.say({spoken().say(first_key())});
    }
    ~TrialScreen() { stop_.watch(nullptr); }
    TrialScreen(const TrialScreen&) = delete;
    TrialScreen& operator=(const TrialScreen&) = delete;

    // Until it has an end, the learner has seen it, or somebody leaves.
    TrialLeft play(std::optional<double> end_s) {
        while (!left_) {
            take(desktop_.window->poll());
            trial_.frame(stop_.stopped());
            if (trial_.trial().end() == FirstUseEnd::good) {
                left_ = TrialLeft::done;
            }
            ask();
            tell_end();
            desktop_.picture->show(compose());
            desktop_.finish_frame();
            if (end_s && monotonic_now_s() >= *end_s) {
                left_ = TrialLeft::time_is_up;
            }
        }
        return *left_;
    }

  private:
    void take(const WindowEvents& events) {
        if (events.close || interrupted()) {
            left_ = TrialLeft::closed;
        }
        stop_.hear(stop_signals_seen());
        stop_.watch_gate(trial_.channels().state_for_lesson.value().gate == GatePhase::stopped);
        if (events.lost_focus) {
            stop_.lose_focus(true, true);
        }
        if (events.button_press[0]) {
            const auto spot = desktop_.picture->spot_at(events.press_x_px, events.press_y_px);
            if (spot && spot->choice >= 0 && spot->choice < static_cast<int>(choices_.size()) &&
                choices_[static_cast<std::size_t>(spot->choice)] == spot->said) {
                chosen_ = spot->choice;
                answer();
            }
        }
        for (const KeyPress& press : events.pressed) {
            if (press.text.empty()) {
                take_key(press);
            } else if (!choices_.empty()) {
                typing_.add(press.text);
                chosen_ = -1;
            }
        }
    }

    void take_key(const KeyPress& press) {
        const StopKey done = stop_.take(press.key, press.repeat, {});
        if (done == StopKey::leave) {
            left_ = TrialLeft::to_menu;
        } else if (done != StopKey::nothing || stop_.stopped()) {
            return;
        } else if (press.key == "backspace") {
            typing_.backspace();
        } else if (press.key == "return" && is_over()) {
            left_ = TrialLeft::done;
        } else if (press.key == "return" && !press.repeat) {
            answer();
        } else if (is_choice_key(press.key) && !choices_.empty()) {
            chosen_ = next_choice(chosen_, static_cast<int>(choices_.size()), press.key);
            typing_.clear();
        }
    }

    void answer() {
        const std::string said = chosen_ >= 0 && chosen_ < static_cast<int>(choices_.size())
                                     ? choices_[static_cast<std::size_t>(chosen_)]
                                     : typing_.text();
        const bool is_asked = trial_.trial().question() != FirstUseQuestion::none;
        const std::string meant = in_english(said);
        is_unclear_ = is_asked && !trial_.trial().answer(meant);
        if (is_asked && !is_unclear_) {
            std::printf("  %s\n", meant.c_str());
            (void)std::fflush(stdout);
        }
        typing_.clear();
        chosen_ = -1;
    }

    // That it gives no force is said aloud as well, once.
    void tell_end() {
        if (is_over() && !has_told_end_) {
            has_told_end_ = true;
            if (const std::string words = end_words(spoken()); !words.empty()) {
                desktop_.say({words});
            }
        }
    }

    // What is asked is said once, aloud as well.
    void ask() {
        const FirstUseQuestion question = trial_.trial().question();
        if (question == asked_) {
            return;
        }
        asked_ = question;
        choices_.clear();
        if (question != FirstUseQuestion::none) {
            for (const std::string& choice : words_.series(key())) {
                choices_.push_back(words_.say(choice));
            }
            desktop_.say({spoken().say(key())});
            std::printf("%s\n", spoken().say(key()).c_str());
            (void)std::fflush(stdout);
        }
    }

    [[nodiscard]] const dialogue::Catalogue& spoken() const { return desktop_.words->english(); }
    // Of the choice that was typed or chosen in the window's language; else as it is.
    [[nodiscard]] std::string in_english(const std::string& said) const {
        const auto choice = std::ranges::find(choices_, dialogue::folded(said), dialogue::folded);
        const auto place = static_cast<std::size_t>(choice - choices_.begin());
        return choice == choices_.end() ? said : spoken().say(words_.series(key()).at(place));
    }
    // In the words of what is held.
    [[nodiscard]] const char* of_device(const char* arm, const char* stick) const {
        return trial_.trial().tried().is_stick ? stick : arm;
    }
    // While nothing is asked.
    [[nodiscard]] const char* first_key() const {
        return is_second_ ? of_device("first_use.hold_second", "first_use.stick_second")
                          : of_device("first_use.hold", "first_use.stick");
    }
    [[nodiscard]] const char* key() const {
        return asked_ == FirstUseQuestion::way ? of_device("first_use.way", "first_use.stick_way")
               : asked_ == FirstUseQuestion::stronger ? "first_use.stronger"
                                                      : first_key();
    }
    [[nodiscard]] bool is_over() const { return trial_.trial().end() != FirstUseEnd::running; }

    // Empty while it runs, and after a good one.
    [[nodiscard]] std::string end_words(const dialogue::Catalogue& catalogue) const {
        const FirstUseEnd end = trial_.trial().end();
        if (end == FirstUseEnd::running || end == FirstUseEnd::good) {
            return {};
        }
        return catalogue.say(end == FirstUseEnd::unfelt
                                 ? of_device("first_use.unfelt", "first_use.stick_unfelt")
                                 : of_device("first_use.off", "first_use.stick_off"),
                             {{"key", "Enter"}});
    }

    [[nodiscard]] View compose() const {
        View view;
        view.tool_visible = false;
        view.caption = words_.say(key());
        view.input = typing_.text();
        view.input_visible = !choices_.empty();
        for (const std::string& choice : choices_) {
            view.choices.push_back({choice, {}});
        }
        view.chosen = chosen_;
        view.feedback = is_unclear_ ? words_.say("first_use.again") : std::string();
        if (stop_.stopped()) {
            view.banner = words_.say("hud.emergency", {{"key", "Enter"}});
            view.banner_is_error = true;
        } else if (const std::string words = end_words(words_); !words.empty()) {
            view.banner = words;
            view.banner_is_error = true;
        }
        return view;
    }

    ForceTrial& trial_;
    Desktop& desktop_;
    const dialogue::Catalogue& words_;
    bool is_second_;
    StopKeys stop_{stop_signals_seen()};
    TypedLine typing_;
    FirstUseQuestion asked_ = FirstUseQuestion::none;
    std::vector<std::string> choices_;
    int chosen_ = -1;
    bool is_unclear_ = false;
    bool has_told_end_ = false;
    std::optional<TrialLeft> left_;
};

}  // namespace

Expected<TrialLeft> try_forces_in_window(LessonRun& run, const RunRequest& request,
                                         ProgressStore& store, Desktop& desktop,
                                         const dialogue::Catalogue& catalogue,
                                         std::optional<double> end_s) {
    constexpr bool kAsked = true;
    for (std::size_t hand = 0; hand < run.hands().size(); ++hand) {
        if (!needs_trial(run.hand_at(hand), request, kAsked)) {
            continue;
        }
        HandDevice& device = *run.hand_at(hand).device;
        auto begun = ForceTrial::begin(device.device(), run.plan().of_hand(hand).safety, kAsked,
                                       device.tried());
        if (!begun) {
            return tl::unexpected(begun.error());
        }
        const TrialLeft left = TrialScreen(**begun, desktop, catalogue, hand > 0).play(end_s);
        const FirstUse trial = (*begun)->trial();
        begun->reset();
        // Who left has not tried it to the end: nothing is known, and nothing is felt.
        if (left != TrialLeft::done) {
            return left;
        }
        take_trial(run.hand_at(hand), hand == 0 ? "" : "The second hand: ", trial, kAsked, request,
                   store);
    }
    return TrialLeft::done;
}

}  // namespace fulcrum::runtime
