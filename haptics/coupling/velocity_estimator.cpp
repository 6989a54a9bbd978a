#include "haptics/coupling/velocity_estimator.h"

#include "haptics/math/rotation.h"

#include <algorithm>

#include <cmath>
#include <limits>
#include <numbers>

namespace fulcrum {
namespace {

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
    newest_ = (last + 1) % kCapacity;
    positions_[static_cast<std::size_t>(newest_)] = position;
    times_s_[static_cast<std::size_t>(newest_)] = time_s;
    count_ = std::min(count_ + 1, kCapacity);
    if (count_ < 2) {
        return velocity_;
    }
    if (settings_.method == VelocityMethod::filtered_difference) {
        const double dt_s = time_s - times_s_[static_cast<std::size_t>(last)];
        const Vector3 difference = (position - positions_[static_cast<std::size_t>(last)]) / dt_s;
        velocity_ += compute_low_pass_share(settings_.cutoff_Hz, dt_s) * (difference - velocity_);
    } else {
        for (int axis = 0; axis < 3; ++axis) {
            velocity_[axis] = compute_window_slope(axis);
        }
    }
    return velocity_;
}

double VelocityEstimator::compute_window_slope(int axis) const noexcept {
    // The line ends in the newest sample; sample i lies within d of it when its slope b satisfies
    //   |y_k - y_(k-i) - b tau_i| <= d   <=>   (y_k - y_(k-i) - d) / tau_i <= b <= (y_k - y_(k-i) +
    //   d) / tau_i.
    const double newest_m = positions_[static_cast<std::size_t>(newest_)][axis];
    const double now_s = times_s_[static_cast<std::size_t>(newest_)];
    double lowest = -std::numeric_limits<double>::infinity();
    double highest = std::numeric_limits<double>::infinity();
    double slope = 0.0;
    // Encoder steps lie exactly d apart: rounding must not decide.
    constexpr double kTie = 1.0 + 1.0e-6;
    const double bound_m = settings_.noise_bound_m * kTie;
    for (int i = 1; i < count_; ++i) {
        const auto slot = static_cast<std::size_t>((newest_ + kCapacity - i) % kCapacity);
        const double tau_s = now_s - times_s_[slot];
        const double rise_m = newest_m - positions_[slot][axis];
        // The window of i intervals holds when its own slope suits every sample inside it.
        const double candidate = rise_m / tau_s;
        if (candidate < lowest || candidate > highest) {
            break;
        }
        slope = candidate;
        lowest = std::max(lowest, (rise_m - bound_m) / tau_s);
        highest = std::min(highest, (rise_m + bound_m) / tau_s);
    }
    return slope;
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
