#include "haptics/surface/transient.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

constexpr double kEnd = 6.9;  // time constants until a thousandth is left

}  // namespace

std::complex<double> compute_inverse_model(const HandleModel& handle,
                                           std::complex<double> s) noexcept {
    return handle.mass_kg + (handle.damping_Ns_per_m + handle.stiffness_N_per_m / s) / s;
}

void Transient::start(const TransientSettings& settings, const HandleModel& handle,
                      double speed_m_per_s) noexcept {
    stop();
    if (!settings.any() || !(speed_m_per_s > 0.0) || !std::isfinite(speed_m_per_s)) {
        return;
    }
    rate_ = {-settings.decay_per_s, 2.0 * std::numbers::pi * settings.frequency_Hz};
    left_s_ = kEnd / settings.decay_per_s;
    switch (settings.kind) {
        case TransientKind::none:
            return;
        case TransientKind::fixed_pulse:
            rate_ = 0.0;
            left_s_ = settings.pulse_s;
            now_ = {0.0, settings.force_Ns_per_m * speed_m_per_s};
            break;
        case TransientKind::decaying_sinusoid:
            now_ = settings.force_Ns_per_m * speed_m_per_s;
            break;
        case TransientKind::acceleration_matching:
            now_ =
                settings.acceleration_per_s * speed_m_per_s * compute_inverse_model(handle, rate_);
            break;
    }
    const double size_N = std::abs(now_);
    now_ *= size_N > settings.max_force_N ? settings.max_force_N / size_N : 1.0;
}

double Transient::step(double dt_s) noexcept {
    if (!rings()) {
        return 0.0;
    }
    if (!(dt_s > 0.0)) {
        stop();
        return 0.0;
    }
    const std::complex<double> half = std::exp(0.5 * dt_s * rate_);
    const double force_N = (now_ * half).imag();
    now_ *= half * half;
    // A pulse that ends within the period gives as much of it as is left.
    const double share = std::min(left_s_ / dt_s, 1.0);
    left_s_ -= dt_s;
    return force_N * share;
}

}  // namespace fulcrum
