// The weight of what lies in the tool: it arrives and leaves along the smoothest curve, without a jerk.
//
// A new target starts a quintic in s = t / T from the value, rate and acceleration of that moment
// (p, v, a), with D = target - p:
//   F(s) = p + v T s + a T^2 s^2 / 2 + c3 s^3 + c4 s^4 + c5 s^5
//   c3 =  10 D - 6 v T - 3 a T^2 / 2
//   c4 = -15 D + 8 v T + 3 a T^2 / 2
//   c5 =   6 D - 3 v T -   a T^2 / 2
// It reaches the target at s = 1 with rate and acceleration zero. From rest it is
// p + D (10 s^3 - 15 s^4 + 6 s^5): no overshoot, steepest slope 15/8 D / T. Value, rate and
// acceleration are continuous even when the target changes midway; the price is that a ramp begun
// while the last one still moves may leave the span between the targets, by up to 7 % of it.
//
// Thread: haptic loop. Cost: about 10 ns while it ramps, a comparison when it rests.
// Source: T. Flash, N. Hogan 1985, The coordination of arm movements: an experimentally confirmed
// mathematical model, J. Neuroscience 5(7): the minimum-jerk quintic between boundary states.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

class WeightRamp {
  public:
    /// `onset_s` is T, the time from one target to the next, 0.02 to 5 seconds; smaller is taken as
    /// 0.02.
    explicit WeightRamp(double onset_s) noexcept;

    /// Moves on by `dt_s` towards `target_W` newtons and returns the force on the tool. A target
    /// that is not finite is ignored; a negative or NaN `dt_s` moves nothing.
    const Vector3& step(const Vector3& target_W, double dt_s) noexcept;
    /// Force now, newtons.
    [[nodiscard]] const Vector3& force_W() const noexcept { return force_W_; }
    /// Its first derivative, newtons per second.
    [[nodiscard]] const Vector3& rate_W() const noexcept { return rate_W_; }
    /// Its second derivative, newtons per second squared.
    [[nodiscard]] const Vector3& acceleration_W() const noexcept { return acceleration_W_; }

  private:
    void start(const Vector3& target_W) noexcept;

    double onset_s_;
    double age_s_ = 0.0;
    bool moving_ = false;
    Vector3 target_W_{Vector3::Zero()};
    Vector3 force_W_{Vector3::Zero()};
    Vector3 rate_W_{Vector3::Zero()};
    Vector3 acceleration_W_{Vector3::Zero()};
    Vector3 c_[6] = {Vector3::Zero(), Vector3::Zero(), Vector3::Zero(),
                     Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};  // powers of s
};

}  // namespace fulcrum
