// The hand's velocity from its measured positions, by one of four rules.
//
//   finite_difference     v_k = (y_k - y_(k-1)) / T
//   filtered_difference   u_k = (y_k - y_(k-1)) / T,   v_k = v_(k-1) + a (u_k - v_(k-1)),
//                         a = 1 - exp(-2 pi f_c T)
//   adaptive_window       the longest window, longest_window_s at most, for which the straight line
//                         through its two ends passes within d of every sample between them:
//                         v_k = (y_k - y_(k-n)) / (t_k - t_(k-n));  each axis has a window of its own
//   kalman                the hand's acceleration taken for white noise: kalman_velocity.h
// A position counted in steps of d is wrong by up to d; over one sample that is d / T (55 mm/s for
// 55 um at 1 kHz). The window is long when the hand moves evenly (little noise) and short when it
// turns (little lag). It is the default: over encoder steps of 55 um it is less than half as wrong as
// the 80 Hz low pass while a hand swings slowly (2 cm at 1 Hz and less), where noise is felt most,
// better up to 5 cm at 1 Hz, and worse from 5 cm at 2 Hz on. A test holds that at 1, 2, 4 and 5 kHz.
// `fulcrum bench velocity-estimators` draws all four: noise, lag, cost, and the damping that a wall may have.
//
// Thread: haptic loop. Cost: adaptive_window one division a sample of the window, the others one or two; no allocation.
// Source: F. Janabi-Sharifi, V. Hayward, C.-S. J. Chen 2000, Discrete-time adaptive windowing for
// velocity estimation, IEEE Trans. Control Systems Technology 8(6), the first-order window with
// end-point fit. Here the bound on the slope is kept as an interval that each further sample narrows,
// so that one pass over the window decides.
#pragma once

#include "haptics/base/error.h"
#include "haptics/coupling/kalman_velocity.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace fulcrum {

enum class VelocityMethod : std::uint8_t {
    filtered_difference,
    adaptive_window,
    finite_difference,
    kalman
};

/// "filtered_difference", "adaptive_window", "finite_difference", "kalman".
[[nodiscard]] std::string_view name_of(VelocityMethod method) noexcept;

inline constexpr double kLongestWindow_s = 0.008;
inline constexpr double kHandAccelerationDensity =
    0.004;  ///< m^2/s^3; a lag of 4 ms over steps of 55 um at 1 kHz

/// Fixed at load.
struct VelocitySettings {
    VelocityMethod method = VelocityMethod::adaptive_window;
    double cutoff_Hz = 80.0;  ///< filtered_difference: of the low pass, 1 to 1000
    /// adaptive_window: largest error of one position; kalman: the encoder's step. 1e-9 to 0.1
    double noise_bound_m = 1.0e-5;
    double longest_window_s = kLongestWindow_s;  ///< adaptive_window: 0.0002 to kLongestWindow_s
    /// kalman: spectral density of the hand's acceleration in m^2/s^3, 1e-12 to 1e6
    double acceleration_density = kHandAccelerationDensity;
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const VelocitySettings& settings);

/// Estimates the velocity of a point. The frame is that of the positions given.
class VelocityEstimator {
  public:
    static constexpr int kMostIntervals = 40;  ///< in a window: kLongestWindow_s at 5 kHz

    /// Takes settings that `validate` accepted.
    explicit VelocityEstimator(const VelocitySettings& settings) noexcept : settings_(settings) {}

    /// Forgets all samples; the velocity is zero until two more have come.
    void reset() noexcept;
    /// Adds the position (metres) measured at `time_s` and returns the velocity in metres per
    /// second. A time that is not later than the last one, or a position that is not finite,
    /// changes nothing.
    const Vector3& step(const Vector3& position, double time_s) noexcept;
    /// The newest estimate.
    [[nodiscard]] const Vector3& velocity() const noexcept { return velocity_; }
    [[nodiscard]] const VelocitySettings& settings() const noexcept { return settings_; }

  private:
    void fit_windows() noexcept;

    static constexpr int kCapacity = kMostIntervals + 1;
    VelocitySettings settings_;
    std::array<Vector3, kCapacity> positions_{};  // ring, newest at newest_
    std::array<double, kCapacity> times_s_{};
    int newest_ = 0;
    int count_ = 0;
    Vector3 velocity_{Vector3::Zero()};
    KalmanVelocity kalman_;
};

/// Estimates an angular velocity by low-passed differences: u_k = log(q_k q_(k-1)^-1) / T, in the
/// frame q turns into.
class AngularVelocityEstimator {
  public:
    /// `cutoff_Hz` of the low pass, 1 to 1000.
    explicit AngularVelocityEstimator(double cutoff_Hz) noexcept : cutoff_Hz_(cutoff_Hz) {}

    /// Forgets all samples.
    void reset() noexcept;
    /// Adds the unit quaternion measured at `time_s` and returns radians per second; a time that is
    /// not later changes nothing.
    const Vector3& step(const Quaternion& orientation, double time_s) noexcept;
    /// The newest estimate.
    [[nodiscard]] const Vector3& velocity() const noexcept { return velocity_; }

  private:
    double cutoff_Hz_;
    bool has_sample_ = false;
    Quaternion last_{Quaternion::Identity()};
    double last_time_s_ = 0.0;
    Vector3 velocity_{Vector3::Zero()};
};

}  // namespace fulcrum
