// What somebody at a desk does to a lesson: keys, typed words, the mouse. The same for a window and for who is simulated.
//
//   WindowEvents -> emergency stop and pause first -> keys of the screen, of the answer, of the lesson -> FrameInput
//                -> keys that move the pointer (key_hand.h) -> a place in the world -> the mouse as a hand
//
// While a question is open its answer is typed, or chosen: down and up open the choices, arrow keys go through them (choice_columns.h), return gives the
// chosen one, and opens them where nothing is typed.
//
// Thread: that of the window.
#pragma once

#include "runtime/app/key_hand.h"
#include "runtime/app/lesson_run.h"
#include "runtime/app/stop_keys.h"
#include "runtime/app/typing.h"
#include "runtime/render/camera.h"
#include "runtime/render/glfw/window.h"
#include "runtime/scene/view.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

inline constexpr double kWheelStep_m = 0.02;  ///< depth of one notch
inline constexpr double kWheelReach_m = 0.3;  ///< either way of the middle of the hand's room

/// What keys ask of the screen and not of the lesson.
enum class ScreenOrder : std::uint8_t {
    begin_again,
    leave,
    switch_fullscreen,
    say_again,
    switch_why,
    open_settings,
    play_next
};

class LessonInput {
  public:
    /// `stops_seen`: from outside, before this.
    explicit LessonInput(unsigned stops_seen = 0) : stop_(stops_seen) {}
    /// From now on this play's, with nothing typed yet; null for none. It outlives the next call.
    void begin(LessonRun* run);
    /// What was done in a frame of `dt_s`. `failed`: there is no lesson that plays.
    void take(WindowEvents events, bool failed, const PictureSize& size, double dt_s);
    /// What keys asked of the screen since the last call.
    [[nodiscard]] std::vector<ScreenOrder> take_orders();
    /// What is for the lesson, taken. Asks it for choices where they are wanted, so not between a frame and its reply.
    [[nodiscard]] Expected<FrameInput> take_frame(double now_s, double paused_s = 0.0);
    /// After a frame: a question of its own may not be open any more.
    void look_again();

    /// Somebody has stopped it from outside, so many times since the program began.
    void hear_stops(unsigned seen) {
        stop_.hear(seen);
        stop_.watch_gate(run_ != nullptr && run_->gate() == GatePhase::stopped);
    }

    /// While something else lies over the lesson it is paused, and keys that were held are let go; it goes on afterwards where only this
    /// has paused it.
    void lay_aside(bool aside);
    /// Which hand holds the mouse, from now on; while there is a play.
    void hold_by(bool left_handed) {
        run_->hold_by(left_handed);
        keys_.hold_by(left_handed);
    }

    /// A button of the screen was clicked.
    void press(ScreenButton button);
    /// A place of the picture was clicked: kTypingSpot, or a choice that said this there. One that is offered no more means nothing.
    void pick(int spot, const std::string& said);
    static constexpr int kTypingSpot = -1;

    /// The lesson is over: it is played again, or left.
    [[nodiscard]] bool ended() const {
        return run_ != nullptr && run_->session().result().finished &&
               !run_->session().result().entered;
    }
    enum class EndChoice : std::uint8_t { again, next, leave };
    /// In their order on the screen.
    [[nodiscard]] std::vector<EndChoice> end_choices() const;
    /// Whether there is a next lesson to choose then; of every play.
    void offer_next(bool is_there) { has_next_ = is_there; }
    /// What is typed, and what may be chosen; without pictures.
    void show(View& view) const;
    [[nodiscard]] bool stopped() const { return stop_.stopped(); }
    [[nodiscard]] bool paused() const { return stop_.paused(); }
    [[nodiscard]] bool stands_still() const { return stop_.stands_still(); }
    [[nodiscard]] const std::vector<AnswerChoice>& choices() const { return choices_; }
    [[nodiscard]] int chosen() const { return chosen_; }
    /// The line is there to ask something.
    [[nodiscard]] bool asking() const { return asking_; }
    /// Where the pointer is, in pixels, moved by keys too.
    [[nodiscard]] const Vector2& pointer_px() const { return pointer_px_; }
    /// The same of the pointer that keys move by themselves, where a hand is theirs.
    [[nodiscard]] const Vector2& keys_px() const { return keys_px_; }
    /// How far behind the camera's target the pointer's plane is: without the wheel it goes through the middle of the hand's room.
    [[nodiscard]] double depth_m(const Camera& camera) const {
        return depth_m(camera, 0, wheel_m_);
    }
    [[nodiscard]] double keys_depth_m(const Camera& camera) const {
        return depth_m(camera, keys_hand().value_or(0), keys_wheel_m_);
    }
    [[nodiscard]] const KeyHand& keys() const { return keys_; }

  private:
    [[nodiscard]] bool asked() const;
    [[nodiscard]] bool types() const { return asked() || asking_; }
    void take_key(const KeyPress& press, bool failed);
    bool take_screen_key(const KeyPress& press);
    void take_playing_key(const KeyPress& press);
    void switch_asking();
    void give_answer();
    void show_what_to_do();
    void take_end_choice();
    void choose(const std::string& key);
    [[nodiscard]] std::optional<std::size_t> keys_hand() const;
    [[nodiscard]] double depth_m(const Camera& camera, std::size_t hand, double wheel_m) const;
    void take_pointer_keys(WindowEvents& events, const PictureSize& size, double dt_s);
    void point(const WindowEvents& events, const PictureSize& size);
    void point_by_mouse(const WindowEvents& events, const Camera& camera);

    LessonRun* run_ = nullptr;
    StopKeys stop_;
    KeyHand keys_;
    TypedLine typing_;
    bool asking_ = false;  // the learner has opened the line to ask something
    bool swallows_text_ = false;
    bool lies_aside_ = false;  // and is paused for that alone
    bool plays_ = false;       // somebody has moved or pressed anything
    FrameInput frame_{};
    double wheel_m_ = 0.0;
    Vector2 pointer_px_{Vector2::Zero()};
    // Of a hand that keys alone move.
    std::optional<Vector2> keys_began_px_;
    Vector2 keys_px_{Vector2::Zero()};
    double keys_wheel_m_ = 0.0;
    bool keys_press_ = false;
    std::array<int, 3> clicked_polls_{};  // of each button: it is held so long still
    bool swallows_click_ = false;         // until the button that picked something goes up
    std::vector<ScreenOrder> orders_;

    std::vector<AnswerChoice> choices_;  // of the question asked at this time
    int chosen_ = kTypingSpot;
    bool wants_choices_ = false;
    bool has_next_ = false;
    EndChoice end_choice_ = EndChoice::again;
    double asked_at_s_ = 0.0;
};

}  // namespace fulcrum::runtime
