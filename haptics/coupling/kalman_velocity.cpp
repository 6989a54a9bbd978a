#include "haptics/coupling/kalman_velocity.h"

#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

// Of an error that is uniform within one step.
double compute_variance(double resolution_m) noexcept {
    return resolution_m * resolution_m / 12.0;
}

}  // namespace

double compute_kalman_lag_s(double acceleration_density, double resolution_m,
                            double period_s) noexcept {
    const double density = compute_variance(resolution_m) * period_s;
    return std::numbers::sqrt2 * std::pow(density / acceleration_density, 0.25);
}

double compute_acceleration_density(double lag_s, double resolution_m, double period_s) noexcept {
    const double w0_per_s = std::numbers::sqrt2 / lag_s;
    return compute_variance(resolution_m) * period_s * std::pow(w0_per_s, 4);
}

void KalmanVelocity::start(const Vector3& position) noexcept {
    *this = KalmanVelocity{};
    position_ = position;
}

void KalmanVelocity::step(const Vector3& position, double dt_s, double acceleration_density,
                          double resolution_m) noexcept {
    const double r = compute_variance(resolution_m);
    if (!started_) {
        started_ = true;
        xx_ = r;
        vv_ = kUnknown_m_per_s * kUnknown_m_per_s;
    }
    // Predict: the hand goes on as it went, less surely.
    const double q = acceleration_density;
    xx_ += dt_s * (2.0 * xv_ + dt_s * (vv_ + q * dt_s / 3.0));
    xv_ += dt_s * (vv_ + 0.5 * q * dt_s);
    vv_ += q * dt_s;
    position_ += dt_s * velocity_;
    // Correct: each takes its share of the surprise.
    const double left = r / (xx_ + r);
    position_gain_ = xx_ / (xx_ + r);
    velocity_gain_per_s_ = xv_ / (xx_ + r);
    const Vector3 surprise = position - position_;
    position_ += position_gain_ * surprise;
    velocity_ += velocity_gain_per_s_ * surprise;
    vv_ -= velocity_gain_per_s_ * xv_;
    xv_ *= left;
    xx_ *= left;
}

}  // namespace fulcrum
