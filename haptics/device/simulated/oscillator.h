// One axis with mass, spring, damper and, where there is any, dry friction, over a stretch of time in which the force on
// it is constant: solved exactly, whatever the length of the step.
//
//   m x'' = -k x - b x' + f - f_c sgn(x')          at rest while |f - k x| <= f_c
// Without friction, with y = x - f/k, alpha = b / 2m, w^2 = k/m - alpha^2:
//   y(t) = e^(-alpha t) (y0 c + (v0 + alpha y0) s)
//   v(t) = e^(-alpha t) (v0 c + (a0 + alpha v0) s)      a0 = (f - k x0 - b v0) / m
//   c = cos wt, s = sin(wt)/w   (1, t when critical; when overdamped, written out as two
//   exponentials that fall, for cosh would overflow where e^(-alpha t) has become zero)
// Dry friction is one constant force while the sign of v stays, so the motion is made of such pieces. Each ends where
//   v(t) = 0:   t = atan2(v0 w, -(a0 + alpha v0)) / w,   overdamped  t = atanh(-v0 w / (a0 + alpha v0)) / w,
// for v0 > 0, and mirrored; there the axis sticks, or turns round. Nothing is regularised: a stuck axis does not creep.
//
// Thread: any; a value. Cost: a few operations a step of a length that is known; an arctangent more with dry friction, and
// exponentials for another length and for each turn within a step, of which there are at most dt w / pi + 1.
// Source: the oscillator is any textbook's; the pieces are P. Dahl's and C. Coulomb's dry friction in the form of
// D. Karnopp 1985, Computer simulation of stick-slip friction in mechanical dynamic systems, J. Dynamic Systems,
// Measurement and Control 107(1), with the band of velocities that stick shrunk to zero, since here events are exact.
#pragma once

#include <array>
#include <cstddef>

namespace fulcrum {

/// One degree of freedom over one step of fixed length: (y, v) <- A (y, v) + (yf, vf) f. See the head of this file.
struct OscillatorStep {
    double yy = 1.0, yv = 0.0, vy = 0.0, vv = 1.0;
    double yf = 0.0,
           vf = 0.0;  ///< metres, and metres a second, for each newton that pushes all the while
};
/// The exact step over `dt_s` >= 0 of m y'' = -k y - b y' + f. `mass` > 0, the others 0 or more; SI.
[[nodiscard]] OscillatorStep compute_oscillator_step(double mass, double stiffness, double damping,
                                                     double dt_s) noexcept;

/// What an axis is made of; SI.
struct AxisPlant {
    double mass_kg = 1.0;            ///< above 0
    double damping_Ns_per_m = 0.0;   ///< 0 or more
    double stiffness_N_per_m = 0.0;  ///< 0 or more, towards the axis' origin
    double dry_friction_N = 0.0;     ///< 0 or more
};

/// Where an axis is.
struct AxisState {
    double position_m = 0.0;
    double velocity_m_per_s = 0.0;
};

/// The first time after which the velocity is zero, without friction: infinite when it never is. `speed_m_per_s` >= 0 is
/// the velocity along its own direction, `acceleration_m_per_s2` what it starts with along the same direction.
[[nodiscard]] double find_stop_s(const AxisPlant& plant, double speed_m_per_s,
                                 double acceleration_m_per_s2) noexcept;

/// An axis that moves; keeps the coefficients of the last two lengths of step, since a delay cuts each period in two.
class AxisMotion {
  public:
    AxisMotion() noexcept = default;
    explicit AxisMotion(const AxisPlant& plant) noexcept : plant_(plant) {}

    /// Moves `state` on by `dt_s` >= 0 under a constant `force_N`.
    void step(AxisState& state, double force_N, double dt_s) noexcept;

  private:
    struct Known {
        double dt_s = -1.0;
        OscillatorStep step{};
    };
    [[nodiscard]] const OscillatorStep& know(double dt_s) noexcept;
    void slide(AxisState& state, double force_N, double dt_s) noexcept;

    AxisPlant plant_;
    std::array<Known, 2> known_{};
    std::size_t oldest_ = 0;
};

}  // namespace fulcrum
