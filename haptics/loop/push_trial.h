// One gentle push through a haptic loop, and what the hand did of it: does an arm push the way it is told?
//
//   settle   no force until the gate lets some through and nothing has been wrong for settle_s
//   rise     f(t) = F u s(t / ramp_s),   s(x) = x^2 (3 - 2 x): at most 1.5 F / ramp_s newtons a second
//   hold     f = F u for hold_s
//   fall     as it rose, then done
//   m        mean place in the last kLook_s of `hold`, minus that in the last kLook_s of `settle`
// A hand is a spring about where its owner wants it, so that m = F u / k: along the push. Of two opposite pushes
//   d = (m_+ - m_-) / 2
// slow wandering falls out, and d.u tells: below -least the arm pushes against what it is told, which would make every wall pull and
// every spring throw; above it goes with it, unless d lies across. Nearer to zero nothing was felt, as in a clamped arm. Motors that are exchanged give d.u = 0;
// dry friction in some joints of an arm turns d too, for it gives way along the others alone, by 45 degrees in a WAM: work is done on it
// all the same, so that d.u > 0. The border is at 63 degrees.
// A hand that goes back by more than kMostBack_m, or anywhere by more than kMostWay_m, ends the push at once.
//
// It commands and is limited like a lesson (ForceCommand::linearised): gate, hand guard and the arm's own limits come behind it.
// Thread: lesson loop, some 60 times a second. Cost: nothing to speak of.
// Source: the ramp is the cubic smoothstep; human_impedance.h has hands of 135 to 300 N/m, which 0.8 N moves by 3 to 6 mm.
#pragma once

#include "haptics/base/error.h"
#include "haptics/handover/messages.h"

namespace fulcrum {

struct PushSettings {
    double force_N = 0.8;   ///< 0.1 to kMostPush_N
    double ramp_s = 0.4;    ///< 0.2 to 2
    double hold_s = 0.5;    ///< 0.3 to 3
    double settle_s = 0.4;  ///< 0.3 to 3
};

inline constexpr double kMostPush_N = 3.0;   ///< the dry friction of a heavy arm, and as much again
inline constexpr double kLook_s = 0.2;       ///< over which a place is averaged
inline constexpr double kMostBack_m = 0.01;  ///< against the push
inline constexpr double kMostWay_m = 0.08;   ///< anywhere
inline constexpr double kLeastMotion_m =
    0.001;  ///< of d: several steps of an arm's encoder, and above a hand's tremor
inline constexpr double kMostAside = 2.0;       ///< of d: across against along
inline constexpr int kMostBeginnings = 4;       ///< a push that something disturbed is begun anew
inline constexpr double kLongestWait_s = 10.0;  ///< for the gate

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const PushSettings& settings);

/// How a push ended.
enum class PushEnd : std::uint8_t {
    running,
    done,
    ran_against,  ///< the hand went back by more than kMostBack_m
    ran_away,     ///< the hand went further than kMostWay_m
    disturbed     ///< the gate stayed shut, or something was wrong each time
};

class PushTrial {
  public:
    /// Takes settings that `validate` accepted. `way_W` is a unit vector.
    PushTrial(const PushSettings& settings, const Vector3& way_W);

    /// The force to command until the next call. `state` is the loop's newest, `now_s` the same clock; a time that does not go on, or
    /// a place that is no number, gives none.
    [[nodiscard]] Vector3 step(const HapticState& state, double now_s);

    [[nodiscard]] PushEnd end() const noexcept { return end_; }
    /// m, metres; zero unless it is done.
    [[nodiscard]] const Vector3& motion_W() const noexcept { return motion_W_; }

  private:
    enum class Phase : std::uint8_t { settle, rise, hold, fall };
    struct Mean {
        Vector3 sum{Vector3::Zero()};
        int n = 0;
    };

    void enter(Phase phase, double now_s);
    void begin_anew(double now_s);
    [[nodiscard]] Vector3 settle(const HapticState& state, double now_s);
    [[nodiscard]] Vector3 push(const HapticState& state, double now_s);
    void look(Mean& mean, const HapticState& state, double left_s);

    PushSettings settings_;
    Vector3 way_W_;
    PushEnd end_ = PushEnd::running;
    Phase phase_ = Phase::settle;
    bool started_ = false;
    double last_s_ = 0.0;
    double entered_s_ = 0.0;
    double waited_from_s_ = 0.0;
    int beginnings_ = 1;
    Mean before_{};
    Mean during_{};
    Vector3 motion_W_{Vector3::Zero()};
};

/// What two opposite pushes show.
enum class PushVerdict : std::uint8_t { with, against, aside, unfelt };

/// `plus_W` and `minus_W`: m of a push along `way_W` and of one against it. What is not finite is `unfelt`.
[[nodiscard]] PushVerdict judge_pushes(const Vector3& way_W, const Vector3& plus_W,
                                       const Vector3& minus_W);

}  // namespace fulcrum
