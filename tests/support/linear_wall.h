// A sampled virtual wall as a linear system: is it stable, exactly, and what does theory ask for?
//
//   wall      F_k = -K y_k - B v_k,  both ways (a spring and a damper, not a surface that only pushes); v_k by a linear
//             velocity estimator; F_k acts from kT + tau to (k+1)T + tau
//   plant     x = sum q_i,   m_i q_i'' + c_i q_i' + k_i q_i = F - b x'      b: the device's own damping
// One mode is an arm held by a mass, a spring and a damper. Several are a hand with resonances, in the modal form of any
// passive structure driven at one point. The plant is solved exactly between the instants at which the force changes (by
// the matrix exponential, not by the oscillator of the simulated arm), so one period is one matrix, the monodromy matrix,
// and the loop is stable when no eigenvalue of it lies outside the unit circle.
// Passive for every operator, exactly (Colgate and Schenkel), of a wall H(z) = K + B V(z), at w = theta / T:
//   b > T/2 max over 0 < theta <= pi of  Re{(1 - e^(-j theta)) H(e^(j theta))} / (1 - cos theta)
//   finite difference:        K T/2 - B cos theta, so b > K T/2 + |B|
//   a delay of d periods:     H e^(-j d theta),    so b > K (T/2 + dT) + |B| suffices, and for B <= 0 is needed
// Source: J. E. Colgate, G. Schenkel 1997, Passivity of a class of sampled-data systems: application to haptic interfaces,
// J. Robotic Systems 14(1); the wall with a low-passed velocity is in J. M. Brown 1995, A theoretical and experimental
// investigation into the factors affecting the Z-width of a haptic display, appendix A; delay and the boundary of
// stability: T. Hulin, A. Albu-Schaeffer, G. Hirzinger 2014, Passivity and stability boundaries for haptic systems with
// time delay, IEEE Trans. Control Systems Technology 22(4).
#pragma once

#include "haptics/coupling/velocity_estimator.h"

#include <vector>

namespace fulcrum::z_width {

/// One mode of the plant; SI.
struct Mode {
    double mass_kg = 1.0;
    double damping_Ns_per_m = 0.0;
    double stiffness_N_per_m = 0.0;
};

struct LinearWall {
    std::vector<Mode> modes{Mode{}};
    double device_damping_Ns_per_m = 0.0;  ///< b
    double stiffness_N_per_m = 0.0;        ///< K
    double damping_Ns_per_m = 0.0;         ///< B, either sign
    double period_s = 0.001;               ///< T
    double delay_s = 0.0;                  ///< tau, 0 or more
    /// Any but the adaptive window, which is not linear.
    VelocitySettings velocity{.method = VelocityMethod::finite_difference};
};

/// The largest magnitude of an eigenvalue of the monodromy matrix: below 1 the loop comes to rest.
[[nodiscard]] double compute_spectral_radius(const LinearWall& wall);

inline constexpr double kStiffestLinear_N_per_m = 1.0e7;
/// The largest K, from 1 N/m to kStiffestLinear_N_per_m, up to which the loop comes to rest; below 1 when 1 does not.
[[nodiscard]] double find_linear_boundary(LinearWall wall, double tolerance = 1e-5);

/// The device's damping (Ns/m) above which the wall is passive whoever holds the device, K T/2 + |B|, with a delay
/// K (T/2 + tau) + |B|, which then suffices.
[[nodiscard]] double compute_passive_damping(const LinearWall& wall);
/// The same exactly, for any linear estimator and a delay of whole periods: the maximum over all frequencies.
[[nodiscard]] double compute_exact_passive_damping(const LinearWall& wall);

/// A hand of `n` resonances at 1, 3, 5, ... times the Nyquist frequency pi / T, each of `mass_kg`: the worst one for B > 0.
/// Sampling folds all of them onto the Nyquist frequency, where the hold lets through (2 / pi i)^2 of each, twice.
[[nodiscard]] std::vector<Mode> make_nyquist_hand(int n, double mass_kg, double period_s);
/// The share of the full effect that `n` of them have: 8/pi^2 (1 + 1/9 + 1/25 + ...), which tends to 1.
[[nodiscard]] double compute_nyquist_share(int n);

/// The largest x in [low, high] up to which `holds` is true, to a relative `tolerance`: steps by a tenth until it fails,
/// then halves. `low` / 1.1 where it fails at once, `high` where it never does.
template <class Holds>
[[nodiscard]] double find_largest(Holds holds, double low, double high, double tolerance) {
    constexpr double kStep = 1.1;
    double good = low / kStep;
    double bad = low;
    while (bad <= high && holds(bad)) {
        good = bad;
        bad *= kStep;
    }
    if (bad > high) {
        return high;
    }
    while (good >= low && bad - good > tolerance * good) {
        const double middle = 0.5 * (good + bad);
        (holds(middle) ? good : bad) = middle;
    }
    return good;
}

}  // namespace fulcrum::z_width
