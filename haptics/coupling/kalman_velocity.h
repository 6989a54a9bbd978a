// Velocity by a Kalman filter that takes the hand's acceleration for white noise.
//
//   state s = (x, v) of each axis:  s(t + T) = [1 T; 0 1] s(t) + w,   cov w = q [T^3/3 T^2/2; T^2/2 T]
//   measured y = x + e,             e uniform within an encoder step d: var e = r = d^2 / 12
//   predict  P <- A P A' + Q;       correct  g = P (1 0)' / (P_xx + r),  s <- s + g (y - x),  P <- P - g (P_xx P_xv)
// q (m^2/s^3) is the spectral density of the acceleration: how suddenly a hand moves. The covariance depends on the times
// alone, so the three axes share it, and each period may have its own length. Once it has settled at a period T, short
// beside 1/w0, the filter is the second-order Butterworth low pass of a differentiator,
//   v/x = s w0^2 / (s^2 + sqrt2 w0 s + w0^2),   w0 = (q / r T)^(1/4):   it lags sqrt2 / w0 behind a hand that speeds up.
// The first sample starts it at rest with a velocity known to kUnknown_m_per_s, so that the second gives the difference.
//
// Thread: haptic loop. Cost: about 20 ns; a division a step.
// Source: R. E. Kalman 1960, A new approach to linear filtering and prediction problems, J. Basic Engineering 82(1); the
// model is Y. Bar-Shalom, X.-R. Li, T. Kirubarajan 2001, Estimation with applications to tracking and navigation, section
// 6.2 (continuous white noise acceleration); for encoders P. R. Belanger, P. Dobrovolny, A. Helmy, X. Zhang 1998,
// Estimation of angular velocity and acceleration from shaft-encoder measurements, Int. J. Robotics Research 17(11).
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

/// The filter's lag in seconds behind a steady acceleration, once settled, at a period short beside it: sqrt2 / w0.
[[nodiscard]] double compute_kalman_lag_s(double acceleration_density, double resolution_m,
                                          double period_s) noexcept;
/// The acceleration density q (m^2/s^3) that gives this lag: the inverse of the above.
[[nodiscard]] double compute_acceleration_density(double lag_s, double resolution_m,
                                                  double period_s) noexcept;

class KalmanVelocity {
  public:
    static constexpr double kUnknown_m_per_s = 10.0;  ///< the hand's speed before anything is known

    /// Forgets everything and takes the first position, in metres.
    void start(const Vector3& position) noexcept;
    /// Takes the position `dt_s` > 0 after the last one; `acceleration_density` q > 0, encoder step `resolution_m` > 0.
    void step(const Vector3& position, double dt_s, double acceleration_density,
              double resolution_m) noexcept;
    /// Metres per second, after the newest position.
    [[nodiscard]] const Vector3& velocity() const noexcept { return velocity_; }
    /// What the last position's surprise was multiplied by: of the position (a pure number) and the velocity (1/s).
    [[nodiscard]] double position_gain() const noexcept { return position_gain_; }
    [[nodiscard]] double velocity_gain_per_s() const noexcept { return velocity_gain_per_s_; }

  private:
    Vector3 position_{Vector3::Zero()};
    Vector3 velocity_{Vector3::Zero()};
    // The covariance: m^2, m^2/s, m^2/s^2.
    double xx_ = 0.0, xv_ = 0.0, vv_ = 0.0;
    bool started_ = false;
    double position_gain_ = 0.0;
    double velocity_gain_per_s_ = 0.0;
};

}  // namespace fulcrum
