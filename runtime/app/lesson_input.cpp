#include "runtime/app/lesson_input.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {

void LessonInput::begin(LessonRun* run) {
    run_ = run;
    stop_.watch(run != nullptr ? &run->channels() : nullptr);
    typing_.clear();
    asking_ = false;
    frame_ = {};
    keys_.hold_by(run != nullptr && run->left_handed());
    choices_.clear();
    chosen_ = kTypingSpot;
    wants_choices_ = false;
}

bool LessonInput::asked() const {
    return run_ != nullptr && run_->session().hud().question_open;
}

void LessonInput::take(WindowEvents events, bool failed, const PictureSize& size, double dt_s) {
    if (events.lost_focus && run_ != nullptr) {
        stop_.lose_focus(run_->device().traits().renders_force);
    }
    keys_.take(events, types(), size, dt_s);
    for (const KeyPress& press : events.pressed) {
        if (press.text.empty()) {
            take_key(press, failed);
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
                         .finished = !failed && run_->session().result().finished};
    const StopKey done = stop_.take(press.key, press.repeat, state);
    if (done == StopKey::leave) {
        orders_.push_back(ScreenOrder::leave);
    } else if (failed && press.key == "return" && !press.repeat) {
        orders_.push_back(ScreenOrder::begin_again);
    } else if (done == StopKey::nothing && !failed && !stop_.stopped()) {
        take_playing_key(press);
    }
}

void LessonInput::take_playing_key(const KeyPress& press) {
    const bool open = asked();
    if (press.key == "f11") {
        orders_.push_back(ScreenOrder::switch_fullscreen);
    } else if (press.key == "f2") {
        orders_.push_back(ScreenOrder::say_again);
    } else if (press.key == "f3" && !press.repeat) {
        orders_.push_back(ScreenOrder::switch_why);
    } else if (press.key == "tab" && run_->session().hud().may_ask) {
        asking_ = !asking_;
        typing_.clear();
    } else if (press.key == "backspace") {
        typing_.backspace();
    } else if (types() && press.key == "return") {
        give_answer();
    } else if (open && (press.key == "down" || press.key == "up")) {
        choose(press.key == "down" ? 1 : -1);
    } else if (!press.repeat && !open && !asking_) {
        frame_.keys.push_back(press.key);
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

void LessonInput::choose(int step) {
    const auto n = static_cast<int>(choices_.size());
    if (n == 0) {
        wants_choices_ = true;
        return;
    }
    typing_.clear();
    chosen_ = chosen_ == kTypingSpot ? (step > 0 ? 0 : n - 1) : (chosen_ + step + n) % n;
}

void LessonInput::pick(int spot) {
    swallows_click_ = true;
    if (spot == kTypingSpot) {
        wants_choices_ = asked();
        return;
    }
    if (asked() && spot < static_cast<int>(choices_.size())) {
        chosen_ = spot;
        give_answer();
    }
}

double LessonInput::depth_m(const Camera& camera) const {
    const Vector3 middle_W = run_->description().hand.centre_W;
    return pointer_plane_normal(camera).dot(middle_W - camera.target_W()) + wheel_m_;
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
    if (run_ == nullptr || hand_ != HandKind::mouse) {
        return;
    }
    const Camera camera(run_->description().camera, size.width_px, size.height_px);
    const auto place_W = pointer_on_plane(camera, pointer_px_, depth_m(camera));
    std::uint32_t buttons = 0;
    for (std::size_t i = swallows_click_ ? 1 : 0; i < events.button_down.size(); ++i) {
        buttons |= events.button_down[i] ? 1U << i : 0U;
    }
    if (place_W) {
        run_->point_at(*place_W, buttons);
    }
}

std::vector<ScreenOrder> LessonInput::take_orders() {
    return std::exchange(orders_, {});
}

Expected<FrameInput> LessonInput::take_frame(double now_s) {
    if (std::exchange(wants_choices_, false) && asked() && choices_.empty()) {
        auto choices = run_->make_choices();
        if (!choices) {
            return tl::unexpected(choices.error());
        }
        choices_ = std::move(*choices);
        chosen_ = choices_.empty() ? kTypingSpot : 0;
    }
    frame_.time_s = now_s;
    return std::exchange(frame_, {});
}

void LessonInput::look_again() {
    const SessionHud& hud = run_->session().hud();
    asking_ = asking_ && hud.may_ask;
    if (!hud.question_open || hud.question_asked_at_s != asked_at_s_) {
        asked_at_s_ = hud.question_asked_at_s;
        choices_.clear();
        chosen_ = kTypingSpot;
    }
}

// The first thing of the scene that the answer names.
std::string LessonInput::picture_of(const AnswerChoice& choice) const {
    const std::vector<BodyDescription>& bodies = run_->description().bodies;
    for (const auto& [slot, word] : choice.meaning) {
        const auto body = std::ranges::find(bodies, word, &BodyDescription::noun);
        if (body != bodies.end() && !word.empty() && body->boxes.empty()) {
            return body->model;
        }
    }
    return {};
}

void LessonInput::show(View& view) const {
    view.input = typing_.text();
    view.input_visible = view.input_visible || asking_;
    for (const AnswerChoice& choice : choices_) {
        view.choices.push_back({choice.said, picture_of(choice)});
    }
    view.chosen = chosen_;
}

}  // namespace fulcrum::runtime
