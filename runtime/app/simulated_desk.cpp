#include "runtime/app/simulated_desk.h"

#include "dialogue/marking/mark_answer.h"
#include "dialogue/unicode.h"
#include "runtime/render/camera.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr PictureSize kPicture{1280, 720};
constexpr double kNearEnough_px = 1.0;

// One key press a character, as a keyboard gives them: whole characters of UTF-8.
std::vector<std::string> characters_of(const std::string& text) {
    std::vector<std::string> characters;
    for (std::size_t at = 0; at < text.size(); at += characters.back().size()) {
        characters.push_back(text.substr(at, dialogue::character_at(text, at).bytes));
    }
    return characters;
}

}  // namespace

SimulatedDesk::SimulatedDesk(LessonRun& run, PlayedBy by)
    : run_(run), by_(by), pointer_px_(0.5 * kPicture.width_px, kTargetHeight * kPicture.height_px) {
    input_.begin(&run);
}

std::unique_ptr<SimulatedDesk> seat_player(LessonRun& run, const RunRequest& request) {
    if (request.by == PlayedBy::arm) {
        return nullptr;
    }
    return std::make_unique<SimulatedDesk>(run, request.by);
}

void SimulatedDesk::type(const std::string& text) {
    for (std::string& character : characters_of(text)) {
        presses_.push_back({.key = "", .text = std::move(character)});
    }
    press("return");
    ++n_typed_;
}

// What the pupil says is typed, or chosen in its stead; what the pupil asks is typed behind the key for asking.
Expected<void> SimulatedDesk::answer(double now_s) {
    const bool asks = run_.session().hud().may_ask;
    auto said = run_.hear_pupil(now_s);
    if (!said) {
        return tl::unexpected(said.error());
    }
    if (!*said) {
        return {};
    }
    if (asks) {
        press("tab");
    } else if (by_ == PlayedBy::keyboard && (n_chosen_ + n_typed_) % 2 == 1) {
        press("down");
        choosing_ = true;
        said_ = std::move(**said);
        return {};
    }
    type(**said);
    return {};
}

void SimulatedDesk::choose_one() {
    const std::vector<AnswerChoice>& choices = input_.choices();
    choosing_ = false;
    // Who would err in form says it in words of their own.
    const dialogue::Question* const question = run_.session().question();
    const dialogue::Mark mark =
        question != nullptr ? dialogue::mark_answer(*question, said_) : dialogue::Mark{};
    const auto meant = std::ranges::find(choices, mark.slots, &AnswerChoice::meaning);
    if (!mark.understood || !mark.form_right() || meant == choices.end()) {
        type(said_);
        return;
    }
    const auto wanted = static_cast<int>(meant - choices.begin());
    for (int i = std::max(input_.chosen(), 0); i < wanted; ++i) {
        press("down");
    }
    press("return");
    ++n_chosen_;
}

void SimulatedDesk::hold(const std::string& key, bool down, WindowEvents& events) {
    if (down == held_.contains(key)) {
        return;
    }
    if (down) {
        held_.insert(key);
        events.pressed.push_back({.key = key});
    } else {
        held_.erase(key);
        events.released.push_back(key);
    }
}

// Each key is held while its next step does not go beyond.
void SimulatedDesk::steer(const Vector2& away_px, double step_px, WindowEvents& events) {
    const auto far = [&](double px) { return px > std::max(kNearEnough_px, 0.5 * step_px); };
    hold("d", far(away_px.x()), events);
    hold("a", far(-away_px.x()), events);
    hold("s", far(away_px.y()), events);
    hold("w", far(-away_px.y()), events);
}

// The place that is seen where the hand wants to be, on the plane that the wheel has reached.
void SimulatedDesk::move(const HandWish& wish, double dt_s, WindowEvents& events) {
    const Camera camera(run_.description().camera, kPicture.width_px, kPicture.height_px);
    const Vector3 normal = pointer_plane_normal(camera);
    const double depth_m = normal.dot(wish.target_W.position - camera.target_W());
    double plane_m = input_.depth_m(camera);
    const double turn = std::round((depth_m - plane_m) / kWheelStep_m);
    if (!run_.plan().kite && turn != 0.0) {
        const double notch = std::copysign(1.0, turn);
        plane_m += notch * kWheelStep_m;
        if (by_ == PlayedBy::mouse) {
            events.wheel = notch;
        } else {
            events.pressed.push_back({.key = notch > 0.0 ? "page_up" : "page_down"});
        }
    }
    const auto seen = camera.project(wish.target_W.position + (plane_m - depth_m) * normal);
    if (!seen) {
        return;
    }
    const bool types = run_.session().hud().question_open;
    if (by_ == PlayedBy::mouse) {
        const Vector2 before_px = pointer_px_;
        pointer_px_ = {std::round(seen->position_px.x()), std::round(seen->position_px.y())};
        events.pointer_moved = pointer_px_ != before_px;
        events.button_down = {(wish.buttons & 1U) != 0, (wish.buttons & 2U) != 0, false};
    } else if (!types) {
        steer(seen->position_px - pointer_px_, input_.keys().step_px(kPicture, dt_s), events);
        hold("shift", (wish.buttons & 1U) != 0, events);
    } else {
        // Letters are the answer's now; whoever types lets go of the rest, but not of what is gripped.
        for (const char* key : {"w", "a", "s", "d"}) {
            hold(key, false, events);
        }
    }
}

// The other hand's pointer is the keys' own; wheel, letters and buttons of the mouse are left alone.
void SimulatedDesk::move_by_keys(const HandWish& wish, double dt_s, WindowEvents& events) {
    if (find_hand(run_.hands(), HandKind::keys) != 1U) {
        return;
    }
    const Camera camera(run_.description().camera, kPicture.width_px, kPicture.height_px);
    const Vector3 normal = pointer_plane_normal(camera);
    const double depth_m = normal.dot(wish.target_W.position - camera.target_W());
    double plane_m = input_.keys_depth_m(camera);
    const double turn = std::round((depth_m - plane_m) / kWheelStep_m);
    if (turn != 0.0) {
        events.pressed.push_back({.key = turn > 0.0 ? "page_up" : "page_down"});
        plane_m += std::copysign(kWheelStep_m, turn);
    }
    const auto seen = camera.project(wish.target_W.position + (plane_m - depth_m) * normal);
    if (seen && !run_.session().hud().question_open) {
        steer(seen->position_px - input_.keys_px(), input_.keys().step_px(kPicture, dt_s), events);
        hold("shift", (wish.buttons & 1U) != 0, events);
    }
}

Expected<FrameInput> SimulatedDesk::step(double now_s, double dt_s) {
    WindowEvents events;
    events.pointer_x_px = pointer_px_.x();
    events.pointer_y_px = pointer_px_.y();
    const auto wish = run_.hand_at(0).take_wish();
    if (run_.hands().size() > 1 && run_.hand_at(1).wish) {
        move_by_keys(*run_.hand_at(1).wish, dt_s, events);
    }
    if (wish) {
        move(*wish, dt_s, events);
        events.pointer_x_px = pointer_px_.x();
        events.pointer_y_px = pointer_px_.y();
        if (!wish->key.empty()) {
            press(wish->key);
        }
    }
    if (presses_.empty() && choosing_) {
        choose_one();
    } else if (presses_.empty()) {
        if (auto answered = answer(now_s); !answered) {
            return tl::unexpected(answered.error());
        }
    }
    if (!presses_.empty()) {
        events.pressed.push_back(std::move(presses_.front()));
        presses_.pop_front();
    }
    input_.take(std::move(events), false, kPicture, dt_s);
    if (by_ == PlayedBy::keyboard) {
        pointer_px_ = input_.pointer_px();
    }
    return input_.take_frame(now_s);
}

}  // namespace fulcrum::runtime
