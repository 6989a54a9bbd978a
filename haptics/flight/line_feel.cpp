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

// With e: nothing against what was felt last, for that would push, and no more than may be felt.
Vector3 LineFeel::bound(const Vector3& pull_W) const noexcept {
    const Vector3 sum_W = pull_W + left_W_;
    const Vector3 along_W = compute_direction(compute_length(felt_W_) > 0.0 ? felt_W_ : pull_W);
    return shorten(sum_W - std::min(along_W.dot(sum_W), 0.0) * along_W, settings_.most_N);
}

// A newer state changes the pull here by that.
void LineFeel::take_change(const LineState& state, const Vector3& change_W) noexcept {
    const bool is_launch = state.n_launches != before_.n_launches;
    const bool is_snapped = !(state.stiffness_N_per_m > 0.0);
    if (before_.stamp_s < 0.0 || is_launch || is_snapped) {
        left_W_.setZero();
        gain_ = is_launch ? 0.0 : gain_;
        return;
    }
    left_W_ -= change_W;
}

void LineFeel::go_along(double dt_s) noexcept {
    const double left_N = compute_length(left_W_);
    const double less_N =
        std::min(left_N / settings_.smooth_s, settings_.most_change_N_per_s) * dt_s;
    left_W_ = less_N < left_N ? Vector3((1.0 - less_N / left_N) * left_W_) : Vector3::Zero();
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
    const Vector3 held_W = gain_ * bound(before_W);
    held_W_ = {held_W, arm_W.cross(held_W)};
    // And the newest.
    const double age_s = now_s - state.stamp_s;
    const Vector3 pull_W = compute_share(state, tool_W.position);
    const bool is_good = state.stamp_s >= 0.0 && age_s >= -settings_.timeout_s &&
                         age_s <= settings_.timeout_s && is_finite(pull_W);
    const double passed_s = std::max(dt_s, 0.0);
    if (is_good) {
        take_change(state, pull_W - before_W);
        go_along(passed_s);
        last_W_ = pull_W;
    }
    before_ = is_good ? state : LineState{};
    gain_ = std::clamp(
        gain_ + (is_good ? passed_s / settings_.open_s : -passed_s / settings_.fade_s), 0.0, 1.0);
    felt_W_ = bound(last_W_);
    const Vector3 felt_W = gain_ * felt_W_;
    return {felt_W, arm_W.cross(felt_W)};
}

}  // namespace fulcrum
