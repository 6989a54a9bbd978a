// The pull of a line in the hand at the haptic rate, from a line that is simulated at the world's.
//
//   F(x) = max(|F_w| + k (|a - x| - L), 0) (a - x) / |a - x|,   a = x_w + L F_w / |F_w|,  k = E / L
//   felt = gain (share F(x) + e), no push and at most `most_N` long;  the gain opens within `open_s` and fades within `fade_s`
//   e'   = -e / smooth_s, at most `most_change_N_per_s`;   e += what a newer state changes at x, so that nothing leaps
//   torque = R r x felt                                                    r: where the line leaves what the hand holds
// (F_w, x_w) is the world's newest state: its pull, and where the hand was. Around it the hand hangs on a spring as long and as
// stiff as the whole line, towards a place a: along the pull by k, across it as a string by |F| / L. The whole line, not its first
// segment: what stands behind that gives way within a step of the world, and a hand that hung on it alone would feel the world's
// rate. A force towards a place that depends on the distance alone has a potential; so between two states the hand gains nothing
// however it goes, and what power there is comes from the wind through F_w.
// So what the hand does is felt at once, and what the world does in its own time: a line that rings as it is let out, or comes taut
// all at once, neither buzzes nor jerks. Only a line that has snapped lets go at once. With each launch the gain opens anew.
// A state that is older than `timeout_s`, from the future or not finite closes the gain; a slack line pulls nothing.
//
// Thread: haptic loop. Cost: 30 ns. No allocation.
// Source: linearised hand-over between a slow and a fast loop, as field/linearised_wrench.h.
#pragma once

#include "haptics/base/error.h"
#include "haptics/flight/line.h"
#include "haptics/handover/line_state.h"
#include "haptics/math/spatial.h"

#include <cstdint>

namespace fulcrum {

/// Fixed at load.
struct LineFeelSettings {
    double share = 1.0;                 ///< felt newtons a newton of the line, 0 to 10
    double most_N = 5.0;                ///< felt at most, 0 to 10
    Vector3 arm_T{Vector3::Zero()};     ///< r, in the tool's frame, at most a metre
    double timeout_s = 0.1;             ///< 0.01 to 1
    double fade_s = 0.1;                ///< 0.01 to 1
    double open_s = 0.5;                ///< 0.01 to 2
    double smooth_s = 0.15;             ///< 0.001 to 1
    double most_change_N_per_s = 50.0;  ///< 1 to 1000
};

/// Refuses settings outside the ranges above, NaN.
[[nodiscard]] Expected<void> validate(const LineFeelSettings& settings);

/// Of a line whose step has ended, with the hand there.
[[nodiscard]] LineState make_line_state(const KiteLine& line, const Vector3& hand_W,
                                        double stamp_s) noexcept;

class LineFeel {
  public:
    /// Takes settings that `validate` accepted.
    explicit LineFeel(const LineFeelSettings& settings) noexcept : settings_(settings) {}

    /// The wrench on the hand about the tool's middle, world frame.
    [[nodiscard]] Wrench step(const LineState& state, const Pose& tool_W, double now_s,
                              double dt_s) noexcept;
    /// What the state and the gain of the step before would have given at the place of the last step: what changed since is not
    /// the hand's doing (coupling/elastic_force.h).
    [[nodiscard]] const Wrench& held_W() const noexcept { return held_W_; }

  private:
    [[nodiscard]] Vector3 compute_share(const LineState& state,
                                        const Vector3& hand_W) const noexcept;
    void take_change(const LineState& state, const Vector3& change_W) noexcept;
    void go_along(double dt_s) noexcept;
    [[nodiscard]] Vector3 bound(const Vector3& pull_W) const noexcept;

    LineFeelSettings settings_;
    double gain_ = 0.0;                // 0 closed to 1 open
    Vector3 last_W_{Vector3::Zero()};  // before the gain, of the last state that was good
    Vector3 left_W_{Vector3::Zero()};  // e
    Vector3 felt_W_{Vector3::Zero()};  // before the gain, in the last step
    LineState before_{};               // of the last step; an old stamp where it was not good
    Wrench held_W_{};
};

}  // namespace fulcrum
