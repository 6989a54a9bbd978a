#include "haptics/coupling/velocity_estimator.h"

#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fulcrum {
namespace {

// A loop's rounds come a little early or late; the sample that is meant to end the window still does.
constexpr double kJitter_s = 0.0001;

// The share of a new value that a first-order low pass lets in over dt_s.
double compute_low_pass_share(double cutoff_Hz, double dt_s) noexcept {
    return 1.0 - std::exp(-2.0 * std::numbers::pi * cutoff_Hz * dt_s);
}

}  // namespace

void VelocityEstimator::reset() noexcept {
    count_ = 0;
    velocity_.setZero();
}

const Vector3& VelocityEstimator::step(const Vector3& position, double time_s) noexcept {
    const int last = newest_;
    const bool later = count_ == 0 || time_s > times_s_[static_cast<std::size_t>(last)];
    if (!later || !std::isfinite(time_s) || !is_finite(position)) {
        return velocity_;
    }
    const bool is_first = count_ == 0;
    const double dt_s = is_first ? 0.0 : time_s - times_s_[static_cast<std::size_t>(last)];
    const Vector3 rise = position - positions_[static_cast<std::size_t>(last)];
    newest_ = (last + 1) % kCapacity;
    positions_[static_cast<std::size_t>(newest_)] = position;
    times_s_[static_cast<std::size_t>(newest_)] = time_s;
    count_ = std::min(count_ + 1, kCapacity);
    if (is_first) {
        if (settings_.method == VelocityMethod::kalman) {
            kalman_.start(position);
        }
        return velocity_;
    }
    switch (settings_.method) {
        case VelocityMethod::finite_difference:
            velocity_ = rise / dt_s;
            break;
        case VelocityMethod::filtered_difference:
            velocity_ +=
                compute_low_pass_share(settings_.cutoff_Hz, dt_s) * (rise / dt_s - velocity_);
            break;
        case VelocityMethod::adaptive_window:
            fit_windows();
            break;
        case VelocityMethod::kalman:
            kalman_.step(position, dt_s, settings_.acceleration_density, settings_.noise_bound_m);
            velocity_ = kalman_.velocity();
            break;
    }
    return velocity_;
}

void VelocityEstimator::fit_windows() noexcept {
    // The line ends in the newest sample; the sample tau before it lies within d of the line when
    // the line's slope b satisfies
    //   |rise - b tau| <= d   <=>   (rise - d) / tau <= b <= (rise + d) / tau.
    const Vector3& newest_m = positions_[static_cast<std::size_t>(newest_)];
    const double now_s = times_s_[static_cast<std::size_t>(newest_)];
    double lowest[3];
    double highest[3];
    bool grows[3] = {true, true, true};
    std::fill_n(lowest, 3, -std::numeric_limits<double>::infinity());
    std::fill_n(highest, 3, std::numeric_limits<double>::infinity());
    // Encoder steps lie exactly d apart: rounding must not decide.
    constexpr double kTie = 1.0 + 1.0e-6;
    const double bound_m = settings_.noise_bound_m * kTie;
    for (int i = 1; i < count_ && (grows[0] || grows[1] || grows[2]); ++i) {
        const auto slot = static_cast<std::size_t>((newest_ + kCapacity - i) % kCapacity);
        const double tau_s = now_s - times_s_[slot];
        if (i > 1 && tau_s > settings_.longest_window_s + kJitter_s) {
            break;
        }
        const double rate_per_s = 1.0 / tau_s;
        for (int axis = 0; axis < 3; ++axis) {
            // The window up to this sample holds when its own slope suits every sample inside it.
            const double rise_m = newest_m[axis] - positions_[slot][axis];
            const double slope = rise_m * rate_per_s;
            grows[axis] = grows[axis] && slope >= lowest[axis] && slope <= highest[axis];
            if (grows[axis]) {
                velocity_[axis] = slope;
                lowest[axis] = std::max(lowest[axis], (rise_m - bound_m) * rate_per_s);
                highest[axis] = std::min(highest[axis], (rise_m + bound_m) * rate_per_s);
            }
        }
    }
}

void AngularVelocityEstimator::reset() noexcept {
    has_sample_ = false;
    velocity_.setZero();
}

const Vector3& AngularVelocityEstimator::step(const Quaternion& orientation,
                                              double time_s) noexcept {
    const double dt_s = time_s - last_time_s_;
    if (!orientation.coeffs().allFinite() || !std::isfinite(time_s) ||
        (has_sample_ && !(dt_s > 0.0))) {
        return velocity_;
    }
    if (has_sample_) {
        const Vector3 difference = compute_log(orientation * last_.conjugate()) / dt_s;
        velocity_ += compute_low_pass_share(cutoff_Hz_, dt_s) * (difference - velocity_);
    }
    has_sample_ = true;
    last_ = orientation;
    last_time_s_ = time_s;
    return velocity_;
}

}  // namespace fulcrum
