// The first time that a learner holds a device that gives force, an arm or a joystick, it pushes their hand gently, one way after the other, and is watched; where somebody can
// answer they say, in their own words, which way it was and which of two pushes was stronger.
//
//   for each of right, up, left, away, down, near that it can push:   push (loop/push_trial.h) -> "Which way does the arm push?"
//   then that push and half of it up, then half and whole:   "Which push was stronger: the first or the second?"
// A push has 0.8 N. Where it does not move the hand, as on an arm whose own dry friction takes it up, it and all after it have 1.6 N, then
// 3 N.
// Two opposite pushes against which the hand goes, or across, end it: the motors are wired otherwise than the arm says, and no setting
// mends that. What is said wrong is pushed and asked once more; who feels nothing twice is right, whatever moved; then, where all answers together are one turn or mirror M of the pushes, the
// arm stands otherwise than it says, and axes M A are what mends it (device/fitted/axis_order.h); an axis that is not pushed stays itself
// where it can. Of a joystick that lies on a table and pushes in its plane, away is up and to me is down, as with a mouse. A push that moves nothing even then may be
// felt and not seen: what is said decides, and where nobody is asked nothing is known. In every case but a good one there is to be no
// force.
//
// Thread: lesson loop, some 60 times a second. Cost: nothing to speak of.
#pragma once

#include "haptics/device/fitted/axis_order.h"
#include "haptics/loop/push_trial.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// Ways of a push, as the learner says them.
enum class Way : std::uint8_t { right, left, up, down, near, away };
inline constexpr std::size_t kWays = 6;

/// A unit vector, scene's axes.
[[nodiscard]] Vector3 vector_of(Way way);
/// The one way that is named in it: "it goes left", "to me". Nothing where none is, or two are.
[[nodiscard]] std::optional<Way> way_in(std::string_view said);
/// 0 for the first, 1 for the second; nothing where it names neither, or both.
[[nodiscard]] std::optional<int> which_in(std::string_view said);
/// Whether it says that there was no push, or no difference: "I feel nothing", "They are the same."
[[nodiscard]] bool says_nothing(std::string_view said);

/// What is tried.
struct TriedDevice {
    bool is_stick = false;                         ///< a joystick; else an arm
    std::array<bool, 3> pushes{true, true, true};  ///< along which of the person's axes

    /// As people call it.
    [[nodiscard]] const char* name() const noexcept { return is_stick ? "stick" : "arm"; }
};

enum class FirstUseQuestion : std::uint8_t { none, way, stronger };

/// How it came out.
enum class FirstUseEnd : std::uint8_t {
    running,
    good,
    against,  ///< the hand goes against the push
    aside,    ///< or across
    unfelt,   ///< along an axis it did not move and nobody was asked, or who was asked felt nothing
    disturbed,  ///< it could not be tried: let go, stopped, moved
    turned,     ///< the arm stands otherwise than it says
    unsure      ///< the answers fit no way it could stand, or the stronger push was not told
};

class FirstUse {
  public:
    /// `asks`: somebody is there to answer.
    explicit FirstUse(bool asks, const TriedDevice& tried = {});

    /// The force to command until the next call; none while a question is open.
    [[nodiscard]] Vector3 step(const HapticState& state, double now_s);

    /// What is asked now.
    [[nodiscard]] FirstUseQuestion question() const noexcept { return question_; }
    /// True when the words were understood; then the question is closed.
    bool answer(std::string_view said);

    [[nodiscard]] bool asks() const noexcept { return asks_; }
    [[nodiscard]] const TriedDevice& tried() const noexcept { return tried_; }
    [[nodiscard]] FirstUseEnd end() const noexcept { return end_; }
    /// Which axis is against, aside or unfelt, or how the axes are as the learner felt them, where it is turned.
    [[nodiscard]] int axis() const noexcept { return axis_; }
    [[nodiscard]] const std::optional<AxisOrder>& felt() const noexcept { return felt_; }

  private:
    [[nodiscard]] Way way_now() const;
    void begin_push();
    void finish_push();
    void go_on();
    [[nodiscard]] bool judge_axis(Way way);
    void judge_answers();
    void hear_way(std::optional<Way> way);
    void hear_stronger(std::optional<int> which);

    bool asks_;
    TriedDevice tried_;
    std::vector<Way> ways_;  // that it can push, in order
    FirstUseEnd end_ = FirstUseEnd::running;
    FirstUseQuestion question_ = FirstUseQuestion::none;
    std::optional<PushTrial> push_;
    std::size_t next_ = 0;      // of the ways; then of the two pushes that are compared
    std::size_t strength_ = 0;  // how often it was pushed again, stronger
    bool compares_ = false;
    std::size_t round_ = 0;  // of the comparisons
    bool second_try_ = false;
    std::array<std::optional<Vector3>, kWays> motions_W_{};
    std::array<Way, kWays> said_{};
    int axis_ = 0;
    std::optional<AxisOrder> felt_;
};

/// What a teacher should know, one sentence; empty while it runs and where it is good. `axes`: how the arm was set.
[[nodiscard]] std::string tell(const FirstUse& trial, const AxisOrder& axes);

}  // namespace fulcrum::runtime
