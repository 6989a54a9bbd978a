// The force that a tap adds, along the surface's normal and away from it, as a function of the time since the tap.
//
//   fixed_pulse            F(t) = a v                               for t < pulse_s, then 0
//   decaying_sinusoid      F(t) = a v exp(-B t) sin(w t)            w = 2 pi f
//   acceleration_matching  F(t) = Im( A v H(s) exp(s t) ),          s = -B + i w,   H(s) = m + b / s + k / s^2
// v: the speed of the tap. The last makes a handle of mass m, held by a hand of damping b and stiffness k, follow
//   m x'' + b x' + k x = F    with   x'' = A v exp(-B t) sin(w t),  x' and x those of its integrals that die away with it:
// H is what F / x'' is at the complex frequency s, so the model is inverted exactly and nothing drifts. With b = k = 0 it is
// a decaying sinusoid of a = m A. The hand is taken for linear; what it adds is small above some 30 Hz.
// All are shortened, as a whole, to max_force_N, and end when they have decayed to a thousandth.
//
// The device holds each value for a period: F is taken in its middle.
// Thread: haptic loop. Cost: about 40 ns while it rings, else nothing. Source: see transient_settings.h; the sinusoid: A. M.
// Okamura, M. R. Cutkosky, J. T. Dennerlein 2001, Reality-based models for vibration feedback in virtual environments,
// IEEE/ASME Trans. Mechatronics 6(3). The closed form of the inverse is ours.
#pragma once

#include "haptics/coupling/coupling_settings.h"
#include "haptics/surface/transient_settings.h"

#include <complex>

namespace fulcrum {

/// What a force on the handle moves: device and hand as one mass, damper and spring.
struct HandleModel {
    double mass_kg = kHandleMass_kg;  ///< above 0
    double damping_Ns_per_m = 0.0;
    double stiffness_N_per_m = 0.0;
};

/// Force over acceleration of the model at the complex frequency `s` (1/s, not 0), kg.
[[nodiscard]] std::complex<double> compute_inverse_model(const HandleModel& handle,
                                                         std::complex<double> s) noexcept;

class Transient {
  public:
    /// A tap at `speed_m_per_s`; whatever rang before is forgotten. Settings that `validate` accepted; a speed that is not
    /// above 0, or no number, starts nothing.
    void start(const TransientSettings& settings, const HandleModel& handle,
               double speed_m_per_s) noexcept;
    void stop() noexcept { left_s_ = 0.0; }
    [[nodiscard]] bool rings() const noexcept { return left_s_ > 0.0; }

    /// The force for the next `dt_s`, newtons along the normal; 0 when nothing rings. A time that does not go on stops it.
    [[nodiscard]] double step(double dt_s) noexcept;

  private:
    std::complex<double> now_{0.0, 0.0};  // the force is its imaginary part
    std::complex<double> rate_{0.0, 0.0};
    double left_s_ = 0.0;
};

}  // namespace fulcrum
