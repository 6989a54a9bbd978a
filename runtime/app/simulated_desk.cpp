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
constexpr double kGuess_s = 1.5;  // who guesses looks so long before a click

// One key press a character, as a keyboard gives them: whole characters of UTF-8.
std::vector<std::string> characters_of(const std::string& text) {
    std::vector<std::string> characters;
    for (std::size_t at = 0; at < text.size(); at += characters.back().size()) {
        characters.push_back(text.substr(at, dialogue::character_at(text, at).bytes));
    }
    return characters;
}

}  // namespace

SimulatedDesk::SimulatedDesk(LessonRun& run, PlayedBy by, std::uint64_t seed,
                             const PictureSize& picture)
    : run_(run),
      by_(by),
      picture_(picture),
      clumsy_(seed, picture),
      chance_(~seed),
      pointer_px_(0.5 * picture.width_px, kTargetHeight * picture.height_px) {}

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
    } else if (by_ == PlayedBy::keyboard) {
        press("down");
        choosing_ = true;
        said_ = std::move(**said);
        return {};
    }
    type(**said);
    return {};
}

void SimulatedDesk::choose_one(const LessonInput& input) {
    const std::vector<AnswerChoice>& choices = input.choices();
    choosing_ = false;
    // Who would err in form says it in words of their own.
    const bool chooses = (n_chosen_ + n_typed_) % 2 == 1;
    const dialogue::Question* const question = run_.session().question();
    const dialogue::Mark mark =
        question != nullptr ? dialogue::mark_answer(*question, said_) : dialogue::Mark{};
    const auto meant = std::ranges::find(choices, mark.slots, &AnswerChoice::meaning);
    if (!chooses || !mark.understood || !mark.form_right() || meant == choices.end()) {
        type(said_);
        return;
    }
    const auto wanted = static_cast<int>(meant - choices.begin());
    for (int i = std::max(input.chosen(), 0); i < wanted; ++i) {
        press("down");
    }
    press("return");
    ++n_chosen_;
}

// Who cannot read the question yet: after a while a click, and until there are choices one that opens them.
std::optional<int> SimulatedDesk::guess(const LessonInput& input, double now_s) {
    const SessionHud& hud = run_.session().hud();
    if (!hud.question_open || now_s - std::max(hud.question_asked_at_s, guessed_s_) < kGuess_s) {
        return std::nullopt;
    }
    guessed_s_ = now_s;
    const auto n = static_cast<double>(input.choices().size());
    if (n == 0.0) {
        return LessonInput::kTypingSpot;
    }
    return static_cast<int>(chance_.draw_chance() * n);
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
        events.released_places.push_back(key);
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

// In the air it moves nothing; on the glass it is a button that is held.
MousePlace SimulatedDesk::find_finger(const MousePlace& meant) const {
    const auto& bodies = run_.plan().haptic.rigid;
    const bool hovers = meant.buttons == 0 && std::ranges::any_of(bodies, [](const auto& body) {
                            return body.grip_buttons != 0;
                        });
    if (hovers) {
        return {pointer_px_, 0};
    }
    return {meant.pointer_px, meant.pointer_px != pointer_px_ ? meant.buttons | 1U : meant.buttons};
}

// The place that is seen where the hand wants to be, on the plane that the wheel has reached.
void SimulatedDesk::move(const LessonInput& input, const HandWish& wish, double now_s, double dt_s,
                         WindowEvents& events) {
    const Camera camera(run_.description().camera, picture_.width_px, picture_.height_px);
    const Vector3 normal = pointer_plane_normal(camera);
    const double depth_m = normal.dot(wish.target_W.position - camera.target_W());
    double plane_m = input.depth_m(camera);
    const double turn = std::round((depth_m - plane_m) / kWheelStep_m);
    if (!run_.plan().kite && turn != 0.0 && by_ != PlayedBy::touch) {
        const double notch = std::copysign(1.0, turn);
        plane_m += notch * kWheelStep_m;
        if (by_ != PlayedBy::keyboard) {
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
    if (by_ != PlayedBy::keyboard) {
        MousePlace place{{std::round(seen->position_px.x()), std::round(seen->position_px.y())},
                         wish.buttons};
        if (by_ == PlayedBy::clumsy) {
            place = clumsy_.step(now_s, dt_s, place);
        } else if (by_ == PlayedBy::touch) {
            place = find_finger(place);
        }
        events.pointer_moved = place.pointer_px != pointer_px_;
        pointer_px_ = place.pointer_px;
        events.button_down = {(place.buttons & 1U) != 0, (place.buttons & 2U) != 0, false};
    } else if (!types) {
        steer(seen->position_px - pointer_px_, input.keys().step_px(picture_, dt_s), events);
        hold("shift", (wish.buttons & 1U) != 0, events);
    } else {
        // Letters are the answer's now; whoever types lets go of the rest, but not of what is gripped.
        for (const char* key : {"w", "a", "s", "d"}) {
            hold(key, false, events);
        }
    }
}

// The other hand's pointer is the keys' own; wheel, letters and buttons of the mouse are left alone.
void SimulatedDesk::move_by_keys(const LessonInput& input, const HandWish& wish, double dt_s,
                                 WindowEvents& events) {
    if (find_hand(run_.hands(), HandKind::keys) != 1U) {
        return;
    }
    const Camera camera(run_.description().camera, picture_.width_px, picture_.height_px);
    const Vector3 normal = pointer_plane_normal(camera);
    const double depth_m = normal.dot(wish.target_W.position - camera.target_W());
    double plane_m = input.keys_depth_m(camera);
    const double turn = std::round((depth_m - plane_m) / kWheelStep_m);
    if (turn != 0.0) {
        events.pressed.push_back({.key = turn > 0.0 ? "page_up" : "page_down"});
        plane_m += std::copysign(kWheelStep_m, turn);
    }
    const auto seen = camera.project(wish.target_W.position + (plane_m - depth_m) * normal);
    if (seen && !run_.session().hud().question_open) {
        steer(seen->position_px - input.keys_px(), input.keys().step_px(picture_, dt_s), events);
        hold("shift", (wish.buttons & 1U) != 0, events);
    }
}

Expected<DeskDeed> SimulatedDesk::act(const LessonInput& input, double now_s, double dt_s) {
    DeskDeed deed;
    WindowEvents& events = deed.events;
    // Where keys have moved it.
    pointer_px_ = by_ == PlayedBy::keyboard && moved_ ? input.pointer_px() : pointer_px_;
    moved_ = true;
    events.pointer_x_px = pointer_px_.x();
    events.pointer_y_px = pointer_px_.y();
    const auto wish = by_ == PlayedBy::idle ? std::nullopt : run_.hand_at(0).take_wish();
    if (run_.hands().size() > 1 && run_.hand_at(1).wish) {
        move_by_keys(input, *run_.hand_at(1).wish, dt_s, events);
    }
    if (wish) {
        move(input, *wish, now_s, dt_s, events);
        events.pointer_x_px = pointer_px_.x();
        events.pointer_y_px = pointer_px_.y();
        if (!wish->key.empty()) {
            press(wish->key);
        }
    }
    if (guesses(by_)) {
        deed.spot = guess(input, now_s);
    } else if (presses_.empty() && choosing_) {
        choose_one(input);
    } else if (presses_.empty()) {
        if (auto answered = answer(now_s); !answered) {
            return tl::unexpected(answered.error());
        }
    }
    if (!presses_.empty()) {
        events.pressed.push_back(std::move(presses_.front()));
        presses_.pop_front();
    }
    deed.held = held_;
    return deed;
}

QuietDesk::QuietDesk(LessonRun& run, PlayedBy by, std::uint64_t seed)
    : desk_(run, by, seed, kPicture) {
    input_.begin(&run);
}

Expected<FrameInput> QuietDesk::step(double now_s, double dt_s) {
    auto deed = desk_.act(input_, now_s, dt_s);
    if (!deed) {
        return tl::unexpected(deed.error());
    }
    if (deed->spot) {
        const std::vector<AnswerChoice>& choices = input_.choices();
        input_.pick(*deed->spot,
                    *deed->spot < 0 ? "" : choices[static_cast<std::size_t>(*deed->spot)].said);
    }
    input_.take(std::move(deed->events), false, kPicture, dt_s);
    return input_.take_frame(now_s);
}

std::unique_ptr<QuietDesk> seat_player(LessonRun& run, const RunRequest& request) {
    return request.by == PlayedBy::arm ? nullptr
                                       : std::make_unique<QuietDesk>(run, request.by, request.seed);
}

}  // namespace fulcrum::runtime
