// Somebody at a desk who plays a lesson: what the lesson's simulated hand wants and what the simulated pupil says become
// a pointer, a wheel and keys, and go the way that a real mouse's and keyboard's go (lesson_input.h).
//
//   mouse      the pointer goes to where the hand's place is seen, to the pixel; the wheel turns a notch a frame towards its depth
//   keyboard   keys move the pointer there; page up and down turn the wheel; the choices are opened for each answer, and
//              every second one is chosen instead of typed, where a choice means the same and its form is right
//   touch      a finger on a screen: a mouse without a wheel, whose button is held while it moves; where bodies can be gripped it moves in
//              the air until it grips
//   clumsy     a mouse in a young hand (clumsy_hand.h); of the choices that stand there one is clicked by chance
//   idle       nothing is moved; choices are clicked likewise
//
// Thread: that of the run.  Cost: microseconds a frame.
#pragma once

#include "haptics/math/split_mix.h"
#include "runtime/app/clumsy_hand.h"
#include "runtime/app/lesson_input.h"
#include "runtime/app/lesson_run.h"
#include "runtime/app/run_request.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace fulcrum::runtime {

/// What somebody does for a frame.
struct DeskDeed {
    WindowEvents events;
    std::set<std::string> held;  ///< keys that stay down
    std::optional<int> spot{};   ///< of the picture, clicked: as LessonInput::pick has it
};

class SimulatedDesk {
  public:
    /// `seed`: of what is done by chance. Everything given outlives it.
    SimulatedDesk(LessonRun& run, PlayedBy by, std::uint64_t seed, const PictureSize& picture);

    /// What is done for a frame at `now_s`, `dt_s` after the last one, by whom sees what `input` has to show.
    [[nodiscard]] Expected<DeskDeed> act(const LessonInput& input, double now_s, double dt_s);

  private:
    void move(const LessonInput& input, const HandWish& wish, double now_s, double dt_s,
              WindowEvents& events);
    void move_by_keys(const LessonInput& input, const HandWish& wish, double dt_s,
                      WindowEvents& events);
    [[nodiscard]] MousePlace find_finger(const MousePlace& meant) const;
    void steer(const Vector2& away_px, double step_px, WindowEvents& events);
    void hold(const std::string& key, bool down, WindowEvents& events);
    void press(const std::string& key) { presses_.push_back({.key = key}); }
    void type(const std::string& text);
    [[nodiscard]] Expected<void> answer(double now_s);
    void choose_one(const LessonInput& input);
    [[nodiscard]] std::optional<int> guess(const LessonInput& input, double now_s);

    LessonRun& run_;
    PlayedBy by_;
    PictureSize picture_;
    ClumsyHand clumsy_;
    SplitMix chance_;
    double guessed_s_ = 0.0;
    Vector2 pointer_px_;
    std::deque<KeyPress> presses_;  // one a frame
    std::set<std::string> held_;
    bool moved_ = false;     // before, at all
    bool choosing_ = false;  // the choices have been asked for
    std::string said_;       // typed where there is nothing to choose from
    int n_chosen_ = 0;
    int n_typed_ = 0;
};

/// One without a window.
class QuietDesk {
  public:
    QuietDesk(LessonRun& run, PlayedBy by, std::uint64_t seed);

    /// What was done for a frame at `now_s`, `dt_s` after the last one.
    [[nodiscard]] Expected<FrameInput> step(double now_s, double dt_s);
    /// After the frame.
    void look_again() { input_.look_again(); }

  private:
    LessonInput input_{};
    SimulatedDesk desk_;
};

/// Who plays at a desk, as the request has it; null where an arm plays.
[[nodiscard]] std::unique_ptr<QuietDesk> seat_player(LessonRun& run, const RunRequest& request);

}  // namespace fulcrum::runtime
