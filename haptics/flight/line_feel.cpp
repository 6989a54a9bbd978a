// The step path of line_feel.h.
#include "haptics/flight/line_feel.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// F(x), which pulls or is nothing.
Vector3 compute_pull(const LineState& state, const Vector3& hand_W) noexcept {
    const double force_N = compute_length(state.force_W);
    if (!(force_N > 0.0)) {
        return Vector3::Zero();
    }
    const Vector3 far_W = state.hand_W + state.length_m / force_N * state.force_W;
    const Vector3 way_W = far_W - hand_W;
    const double way_m = compute_length(way_W);
    const double pull_N = force_N + state.stiffness_N_per_m * (way_m - state.length_m);
    if (pull_N <= 0.0 || way_m <= 0.0) {
        return Vector3::Zero();
    }
    return pull_N / way_m * way_W;
}

Vector3 shorten(const Vector3& force_W, double most_N) noexcept {
    const double force_N = compute_length(force_W);
    return force_N > most_N ? Vector3(most_N / force_N * force_W) : force_W;
}

}  // namespace

LineState make_line_state(const KiteLine& line, const Vector3& hand_W, double stamp_s) noexcept {
    const double stiffness_N_per_m =
        line.is_snapped() ? 0.0 : line.settings().stretch_N / line.length_m();
    return {stamp_s, hand_W, line.hand_force_W(), stiffness_N_per_m, line.length_m()};
}

// Before the gain; not finite where state or hand are not.
Vector3 LineFeel::compute_share(const LineState& state, const Vector3& hand_W) const noexcept {
    return shorten(settings_.share * compute_pull(state, hand_W), settings_.most_N);
}

Wrench LineFeel::step(const LineState& state, const Pose& tool_W, double now_s,
                      double dt_s) noexcept {
    const Vector3 arm_W = tool_W.orientation * settings_.arm_T;
    if (!is_finite(tool_W.position) || !is_finite(arm_W)) {
        held_W_ = {};
        return {};
    }
    // The state of the step before, here; where that was not good, what it left behind.
    const Vector3 before_W =
        before_.stamp_s >= 0.0 ? compute_share(before_, tool_W.position) : last_W_;
    const Vector3 held_W = gain_ * before_W;
    held_W_ = {held_W, arm_W.cross(held_W)};
    // And the newest.
    const double age_s = now_s - state.stamp_s;
    const Vector3 pull_W = compute_share(state, tool_W.position);
    const bool is_good = state.stamp_s >= 0.0 && age_s >= -settings_.timeout_s &&
                         age_s <= settings_.timeout_s && is_finite(pull_W);
    before_ = is_good ? state : LineState{};
    last_W_ = is_good ? pull_W : last_W_;
    const double change = dt_s > 0.0 ? dt_s / settings_.fade_s : 0.0;
    gain_ = std::clamp(is_good ? gain_ + change : gain_ - change, 0.0, 1.0);
    const Vector3 felt_W = gain_ * last_W_;
    return {felt_W, arm_W.cross(felt_W)};
}

}  // namespace fulcrum
