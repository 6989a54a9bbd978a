#include "runtime/app/lesson_input.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {

void LessonInput::begin(LessonRun* run) {
    run_ = run;
    stop_.watch(run != nullptr ? &run->channels() : nullptr);
    typing_.clear();
    asking_ = plays_ = false;
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
    const StopKey done = stop_.take(press.key, press.repeat, state);
    if (done == StopKey::leave) {
        orders_.push_back(ScreenOrder::leave);
    } else if (failed && press.key == "return" && !press.repeat) {
        orders_.push_back(ScreenOrder::begin_again);
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
    } else if (press.key == "p" && !types() && !press.repeat) {
        stop_.switch_pause();
    } else {
        return false;
    }
    return true;
}

void LessonInput::take_playing_key(const KeyPress& press) {
    const bool goes = press.key == "down" || press.key == "up";
    if (take_screen_key(press)) {
        return;
    }
    if (ended() && goes) {
        end_choice_ = end_choice_ == EndChoice::again ? EndChoice::leave : EndChoice::again;
    } else if (ended() && press.key == "return" && !press.repeat) {
        take_end_choice();
    } else if (press.key == "backspace") {
        typing_.backspace();
    } else if (types() && press.key == "return") {
        give_answer();
    } else if (asked() && goes) {
        choose(press.key == "down" ? 1 : -1);
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

void LessonInput::press(ScreenButton button) {
    swallows_click_ = true;
    if (button == ScreenButton::pause) {
        return stop_.switch_pause();
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
            return;
    }
}

// While the lesson has not heard the last line yet, this one stays in the box.
void LessonInput::give_answer() {
    if (frame_.typed) {
        return;
    }
    if (chosen_ >= 0 && chosen_ < static_cast<int>(choices_.size())) {
        frame_.typed = choices_[static_cast<std::size_t>(chosen_)].said;
        typing_.clear();
    } else {
        frame_.typed = typing_.take();
    }
    asking_ = false;
    chosen_ = kTypingSpot;
}

// The space bar plays again, whoever presses it.
void LessonInput::take_end_choice() {
    if (end_choice_ == EndChoice::leave) {
        orders_.push_back(ScreenOrder::leave);
    } else {
        frame_.keys.emplace_back("space");
    }
}

void LessonInput::choose(int step) {
    asking_ = false;
    const auto n = static_cast<int>(choices_.size());
    if (n == 0) {
        wants_choices_ = true;
        return;
    }
    typing_.clear();
    chosen_ = chosen_ == kTypingSpot ? (step > 0 ? 0 : n - 1) : (chosen_ + step + n) % n;
}

void LessonInput::pick(int spot, const std::string& said) {
    swallows_click_ = true;
    if (ended()) {
        end_choice_ =
            spot == static_cast<int>(EndChoice::leave) ? EndChoice::leave : EndChoice::again;
        return take_end_choice();
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
    own.released = events.released;
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
    swallows_click_ = swallows_click_ && events.button_down[0];
    pointer_px_ = {events.pointer_x_px, events.pointer_y_px};
    if (run_ == nullptr) {
        return;
    }
    const Camera camera(run_->description().camera, size.width_px, size.height_px);
    point_by_mouse(events, camera);
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
    const auto place_W = pointer_on_plane(camera, pointer_px_, depth_m(camera, *hand, wheel_m_));
    std::uint32_t buttons = 0;
    for (std::size_t i = swallows_click_ ? 1 : 0; i < events.button_down.size(); ++i) {
        buttons |= events.button_down[i] ? 1U << i : 0U;
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
    view.chosen = ended() ? static_cast<int>(end_choice_) : chosen_;
}

}  // namespace fulcrum::runtime
