// A cap that springs back moves a hand by rate: as far as it is pushed, so fast the hand goes; let go, it stays. So it is what
// users of SpaceMice know, and only so the few millimetres of a cap reach the whole scene.
//
//   s(u) = sign(u) ((|u| - d) / (1 - d))^e  beyond the dead zone d, else 0        each of the six by itself
//   v    = v_max s,   held back by what opposes it:  v <- v max(0, 1 - max(0, -f . v/|v|) / f_push)
//   p   <- p + v dt,  held within the workspace      q <- exp(w_max s dt) q
// The second line is the hand that feels nothing and sees: against a weight it goes slower, against a wall it comes to rest.
// A longer step than kLongestRateStep_s moves no further than one of that length: after a pause nothing leaps.
//
// Thread: haptic loop. Cost: about 60 ns.
// Source: S. Zhai, P. Milgram 1998, Quantifying coordination in multiple DOF movement, CHI (rate control suits elastic devices);
// A. Lecuyer et al. 2000, Pseudo-haptic feedback, IEEE Virtual Reality (what is seen to go slower is felt to resist).
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/hid/space_mouse.h"
#include "haptics/math/spatial.h"

namespace fulcrum::hid {

inline constexpr double kLongestRateStep_s = 0.01;

struct RateSettings {
    double max_speed_m_per_s = 0.3;   ///< v_max, in the device's frame, 0.01 to 2
    double max_turn_rad_per_s = 1.5;  ///< w_max, 0 to 10; 0: the hand never turns
    double dead_zone =
        0.06;  ///< d, of the cap's way: a hand that rests on it moves nothing; 0 to 0.5
    double exponent = 2.0;       ///< e: fine near the middle, fast at the end; 1 to 4
    double full_push_N = 6.0;    ///< f_push: what a fully pushed cap can push against; 0.5 to 50
    double half_extent_m = 0.2;  ///< of the workspace, a cube; 0.001 to 10
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const RateSettings& settings);

class RateControl {
  public:
    /// Takes settings that `validate` accepted.
    explicit RateControl(const RateSettings& settings) noexcept : settings_(settings) {}

    /// Where the hand is after `dt_s` under this cap and against this force (newtons, frame D). A time or a force that is not finite
    /// counts as none, and so does a cap's number that is not.
    const Pose& step(const CapState& cap, const Vector3& force_D, double dt_s) noexcept;

    [[nodiscard]] const Pose& pose_D() const noexcept { return pose_D_; }

  private:
    RateSettings settings_;
    Pose pose_D_{};
};

/// s(u) of the first line.
[[nodiscard]] double shape_cap(const RateSettings& settings, double cap) noexcept;

}  // namespace fulcrum::hid
