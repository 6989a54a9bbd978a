// Somebody at a desk who plays a lesson without a window: what the lesson's simulated hand wants and what the simulated pupil says become
// a pointer, a wheel and keys, and go the way that a real mouse's and keyboard's go (lesson_input.h).
//
//   mouse      the pointer goes to where the hand's place is seen, to the pixel; the wheel turns a notch a frame towards its depth
//   keyboard   keys move the pointer there; page up and down turn the wheel; every second answer is chosen instead of typed,
//              where a choice means the same and its form is right
//
// Thread: that of the run.  Cost: microseconds a frame.
#pragma once

#include "runtime/app/lesson_input.h"
#include "runtime/app/lesson_run.h"
#include "runtime/app/run_request.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <set>
#include <string>

namespace fulcrum::runtime {

class SimulatedDesk {
  public:
    SimulatedDesk(LessonRun& run, PlayedBy by);

    /// What was done for a frame at `now_s`, `dt_s` after the last one.
    [[nodiscard]] Expected<FrameInput> step(double now_s, double dt_s);
    /// After the frame.
    void look_again() { input_.look_again(); }

    /// How often an answer was chosen, and how many were typed.
    [[nodiscard]] int n_chosen() const { return n_chosen_; }
    [[nodiscard]] int n_typed() const { return n_typed_; }

  private:
    void move(const HandWish& wish, double dt_s, WindowEvents& events);
    void move_by_keys(const HandWish& wish, double dt_s, WindowEvents& events);
    void steer(const Vector2& away_px, double step_px, WindowEvents& events);
    void hold(const std::string& key, bool down, WindowEvents& events);
    void press(const std::string& key) { presses_.push_back({.key = key}); }
    void type(const std::string& text);
    [[nodiscard]] Expected<void> answer(double now_s);
    void choose_one();

    LessonRun& run_;
    PlayedBy by_;
    LessonInput input_;
    Vector2 pointer_px_;
    std::deque<KeyPress> presses_;  // one a frame
    std::set<std::string> held_;
    bool choosing_ = false;  // the choices have been asked for
    std::string said_;       // typed where there is nothing to choose from
    int n_chosen_ = 0;
    int n_typed_ = 0;
};

/// Who plays at a desk, as the request has it; null where an arm plays.
[[nodiscard]] std::unique_ptr<SimulatedDesk> seat_player(LessonRun& run, const RunRequest& request);

}  // namespace fulcrum::runtime
