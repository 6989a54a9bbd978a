#include "runtime/app/lesson_input.h"

#include "runtime/scene/choice_columns.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace fulcrum::runtime {
namespace {

// By what stands on it, or, where no Latin letter does, by its place.
bool is_pause_key(const KeyPress& press) {
    constexpr unsigned char kFirstOther = 0x80;
    const bool is_latin =
        press.key.empty() || static_cast<unsigned char>(press.key[0]) < kFirstOther;
    return (is_latin ? press.key : press.place) == "p";
}

// A bucket stands on the ground and goes no deeper, wherever the pointer is.
double lowest_hand_m(const LessonDescription& lesson) {
    return lesson.bucket.present ? lesson.ground_height_m + lesson.bucket.opening_radius_m
                                 : -std::numeric_limits<double>::infinity();
}

}  // namespace

void LessonInput::begin(LessonRun* run) {
    run_ = run;
    stop_.watch(run != nullptr ? &run->channels() : nullptr);
    typing_.clear();
    asking_ = plays_ = lies_aside_ = false;
    frame_ = {};
    keys_.hold_by(run != nullptr && run->left_handed());
    keys_began_px_.reset();
    choices_.clear();
    chosen_ = kTypingSpot;
    wants_choices_ = false;
    end_choice_ = EndChoice::again;
}

bool LessonInput::asked() const {
    return run_ != nullptr && run_->session().hud().question_open;
}

void LessonInput::take(WindowEvents events, bool failed, const PictureSize& size, double dt_s) {
    if (events.lost_focus && run_ != nullptr) {
        stop_.lose_focus(renders_force(run_->hands()), plays_);
    }
    plays_ = plays_ || events.pointer_moved || !events.pressed.empty() ||
             (run_ != nullptr && run_->gate() == GatePhase::open);
    take_pointer_keys(events, size, dt_s);
    for (const KeyPress& press : events.pressed) {
        if (press.text.empty()) {
            const bool was_stopped = stop_.stopped();
            take_key(press, failed);
            swallows_text_ = was_stopped && !stop_.stopped();
        } else if (std::exchange(swallows_text_, false)) {
            continue;  // of the key that went on
        } else if (!failed && !stop_.stopped() && types()) {
            typing_.add(press.text);
            chosen_ = kTypingSpot;
        }
    }
    point(events, size);
}

// The emergency stop's keys go before all others; return runs a lesson that failed again.
void LessonInput::take_key(const KeyPress& press, bool failed) {
    const RunState state{.failed = failed,
                         .finished = !failed && run_->session().result().finished,
                         .renders_force = run_ == nullptr || renders_force(run_->hands())};
    const StopKey done = stop_.take(is_pause_key(press) ? "p" : press.key, press.repeat, state);
    if (done == StopKey::leave) {
        orders_.push_back(ScreenOrder::leave);
    } else if (failed && press.key == "return" && !press.repeat) {
        orders_.push_back(ScreenOrder::begin_again);
    } else if (press.key == "f4" && !failed && !press.repeat) {
        orders_.push_back(ScreenOrder::open_settings);
    } else if (done == StopKey::nothing && !failed && !stop_.stopped()) {
        take_playing_key(press);
    }
}

// Of the screen, whatever is played; false for another.
bool LessonInput::take_screen_key(const KeyPress& press) {
    if (press.key == "f11") {
        orders_.push_back(ScreenOrder::switch_fullscreen);
    } else if (press.key == "f2") {
        orders_.push_back(ScreenOrder::say_again);
    } else if (press.key == "f3" && !press.repeat) {
        orders_.push_back(ScreenOrder::switch_why);
    } else if (press.key == "tab") {
        switch_asking();
    } else if (is_pause_key(press) && !types() && !press.repeat) {
        stop_.switch_pause();
    } else {
        return false;
    }
    return true;
}

void LessonInput::take_playing_key(const KeyPress& press) {
    if (take_screen_key(press)) {
        return;
    }
    const bool goes = is_choice_key(press.key);
    if (ended() && goes) {
        const auto choices = end_choices();
        const auto at = std::ranges::find(choices, end_choice_) - choices.begin();
        const auto n = static_cast<std::ptrdiff_t>(choices.size());
        end_choice_ = choices[static_cast<std::size_t>(
            (at + (press.key == "down" || press.key == "right" ? 1 : n - 1)) % n)];
    } else if (ended() && press.key == "return" && !press.repeat) {
        take_end_choice();
    } else if (press.key == "backspace") {
        typing_.backspace();
    } else if (types() && press.key == "return") {
        give_answer();
    } else if (asked() && goes) {
        choose(press.key);
    } else if (!press.repeat && !asked() && !asking_) {
        frame_.keys.push_back(press.key);
    }
}

void LessonInput::switch_asking() {
    if (run_->session().hud().knows) {
        asking_ = !asking_;
        typing_.clear();
        choices_.clear();
        chosen_ = kTypingSpot;
    }
}

void LessonInput::lay_aside(bool aside) {
    keys_.release();
    if (aside) {
        lies_aside_ = !stop_.stopped();
    }
    // A stop that came meanwhile stays.
    if (lies_aside_ && aside != stop_.paused()) {
        stop_.switch_pause();
    }
    lies_aside_ = lies_aside_ && aside;
}

void LessonInput::press(ScreenButton button) {
    swallows_click_ = true;
    if (button == ScreenButton::pause) {
        return stop_.switch_pause();
    }
    if (button == ScreenButton::leave) {
        return orders_.push_back(ScreenOrder::leave);
    }
    if (button == ScreenButton::settings) {
        return orders_.push_back(ScreenOrder::open_settings);
    }
    if (stop_.stopped()) {
        return;
    }
    switch (button) {
        case ScreenButton::say_again:
            return orders_.push_back(ScreenOrder::say_again);
        case ScreenButton::why:
            return orders_.push_back(ScreenOrder::switch_why);
        case ScreenButton::ask:
            return switch_asking();
        case ScreenButton::pause:
        case ScreenButton::settings:
        case ScreenButton::leave:
            return;
    }
}

// While the lesson has not heard the last line yet, this one stays in the box.
void LessonInput::give_answer() {
    if (frame_.typed) {
        return;
    }
    const bool chose = chosen_ >= 0 && chosen_ < static_cast<int>(choices_.size());
    if (!chose && typing_.is_blank()) {
        return show_what_to_do();
    }
    if (chose) {
        frame_.typed = choices_[static_cast<std::size_t>(chosen_)].said;
        typing_.clear();
    } else {
        frame_.typed = typing_.take();
    }
    asking_ = false;
    chosen_ = kTypingSpot;
}

// Nothing is said yet: what may be chosen is shown; where something may be asked the line says so already.
void LessonInput::show_what_to_do() {
    typing_.clear();
    if (asked() && !asking_) {
        wants_choices_ = choices_.empty();
        chosen_ = choices_.empty() ? kTypingSpot : 0;
    }
}

std::vector<LessonInput::EndChoice> LessonInput::end_choices() const {
    if (has_next_) {
        return {EndChoice::again, EndChoice::next, EndChoice::leave};
    }
    return {EndChoice::again, EndChoice::leave};
}

// The space bar plays again, whoever presses it.
void LessonInput::take_end_choice() {
    if (end_choice_ == EndChoice::leave) {
        orders_.push_back(ScreenOrder::leave);
    } else if (end_choice_ == EndChoice::next) {
        orders_.push_back(ScreenOrder::play_next);
    } else {
        frame_.keys.emplace_back("space");
    }
}

void LessonInput::choose(const std::string& key) {
    asking_ = false;
    if (choices_.empty()) {
        // Who walks sideways when something is asked opens nothing.
        wants_choices_ = wants_choices_ || key == "down" || key == "up";
        return;
    }
    typing_.clear();
    chosen_ = next_choice(chosen_, static_cast<int>(choices_.size()), key);
}

void LessonInput::pick(int spot, const std::string& said) {
    swallows_click_ = true;
    if (ended()) {
        const auto choices = end_choices();
        if (spot >= 0 && spot < static_cast<int>(choices.size())) {
            end_choice_ = choices[static_cast<std::size_t>(spot)];
            take_end_choice();
        }
        return;
    }
    if (spot == kTypingSpot) {
        wants_choices_ = asked() && !asking_;
        return;
    }
    if (asked() && spot < static_cast<int>(choices_.size()) &&
        choices_[static_cast<std::size_t>(spot)].said == said) {
        chosen_ = spot;
        give_answer();
    }
}

std::optional<std::size_t> LessonInput::keys_hand() const {
    return run_ != nullptr ? find_hand(run_->hands(), HandKind::keys) : std::nullopt;
}

double LessonInput::depth_m(const Camera& camera, std::size_t hand, double wheel_m) const {
    const LessonDescription& lesson = run_->description();
    const Vector3 middle_W =
        hand == 0 ? lesson.hand.centre_W : lesson.more_hands[hand - 1].centre_W;
    return pointer_plane_normal(camera).dot(middle_W - camera.target_W()) + wheel_m;
}

// Keys move the mouse's pointer, or their own where a hand is theirs: it begins where that hand is at rest.
void LessonInput::take_pointer_keys(WindowEvents& events, const PictureSize& size, double dt_s) {
    const auto hand = keys_hand();
    if (!hand) {
        keys_.take(events, types(), size, dt_s);
        return;
    }
    if (!keys_began_px_) {
        const LessonDescription& lesson = run_->description();
        const Camera camera(lesson.camera, size.width_px, size.height_px);
        const auto seen = camera.project(*hand == 0 ? lesson.hand.centre_W
                                                    : lesson.more_hands[*hand - 1].centre_W);
        keys_px_ = seen ? seen->position_px : Vector2(0.5 * size.width_px, 0.5 * size.height_px);
        keys_began_px_ = keys_px_;
        keys_wheel_m_ = 0.0;
    }
    WindowEvents own;
    own.pressed = events.pressed;
    own.released_places = events.released_places;
    own.lost_focus = events.lost_focus;
    own.pointer_x_px = keys_px_.x();
    own.pointer_y_px = keys_px_.y();
    keys_.take(own, types(), size, dt_s);
    keys_px_ = {own.pointer_x_px, own.pointer_y_px};
    keys_wheel_m_ =
        std::clamp(keys_wheel_m_ + kWheelStep_m * own.wheel, -kWheelReach_m, kWheelReach_m);
    keys_press_ = own.button_down[0];
}

void LessonInput::point(const WindowEvents& events, const PictureSize& size) {
    // The wheel is the reel of a kite, where there is one.
    if (run_ != nullptr && run_->plan().kite) {
        frame_.wheel += events.wheel;
    } else {
        wheel_m_ =
            std::clamp(wheel_m_ + kWheelStep_m * events.wheel, -kWheelReach_m, kWheelReach_m);
    }
    pointer_px_ = {events.pointer_x_px, events.pointer_y_px};
    if (run_ == nullptr) {
        return;
    }
    const Camera camera(run_->description().camera, size.width_px, size.height_px);
    point_by_mouse(events, camera);
    swallows_click_ = swallows_click_ && events.button_down[0];
    if (const auto hand = keys_hand()) {
        if (const auto place_W = pointer_on_plane(camera, keys_px_, keys_depth_m(camera))) {
            run_->hand_at(*hand).device->point_at(*place_W, keys_press_ ? 1U : 0U);
        }
    }
}

void LessonInput::point_by_mouse(const WindowEvents& events, const Camera& camera) {
    const auto hand = find_hand(run_->hands(), HandKind::mouse);
    if (!hand) {
        return;
    }
    auto place_W = pointer_on_plane(camera, pointer_px_, depth_m(camera, *hand, wheel_m_));
    if (place_W) {
        place_W->y() = std::max(place_W->y(), lowest_hand_m(run_->description()));
    }
    std::uint32_t buttons = 0;
    for (std::size_t i = 0; i < events.button_down.size(); ++i) {
        if (i == 0 && swallows_click_) {
            clicked_polls_[0] = 0;
            continue;
        }
        // So long that a lesson's frame sees it, however quick the click was.
        constexpr int kLeastPress_polls = 8;
        clicked_polls_[i] =
            events.button_press[i] ? kLeastPress_polls : std::max(clicked_polls_[i] - 1, 0);
        buttons |= events.button_down[i] || clicked_polls_[i] > 0 ? 1U << i : 0U;
    }
    if (place_W) {
        run_->hand_at(*hand).device->point_at(*place_W, buttons);
    }
}

std::vector<ScreenOrder> LessonInput::take_orders() {
    return std::exchange(orders_, {});
}

Expected<FrameInput> LessonInput::take_frame(double now_s, double paused_s) {
    if (std::exchange(wants_choices_, false) && asked() && choices_.empty()) {
        auto choices = run_->aside().make_choices();
        if (!choices) {
            return tl::unexpected(choices.error());
        }
        choices_ = std::move(*choices);
        run_->session().tell_offer(choices_);
        chosen_ = choices_.empty() ? kTypingSpot : 0;
    }
    frame_.time_s = now_s;
    frame_.paused_s = paused_s;
    return std::exchange(frame_, {});
}

void LessonInput::look_again() {
    const SessionHud& hud = run_->session().hud();
    asking_ = asking_ && hud.knows;
    if (!hud.question_open || hud.question_asked_at_s != asked_at_s_) {
        asked_at_s_ = hud.question_asked_at_s;
        choices_.clear();
        chosen_ = kTypingSpot;
    }
}

void LessonInput::show(View& view) const {
    view.input = typing_.text();
    view.input_visible = view.input_visible || asking_;
    for (const AnswerChoice& choice : choices_) {
        view.choices.push_back({choice.said, {}});
    }
    const auto ends = end_choices();
    view.chosen =
        ended() ? static_cast<int>(std::ranges::find(ends, end_choice_) - ends.begin()) : chosen_;
}

}  // namespace fulcrum::runtime
