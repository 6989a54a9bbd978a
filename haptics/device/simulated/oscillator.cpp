#include "haptics/device/simulated/oscillator.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace fulcrum {
namespace {

constexpr double kNearCritical = 1.0e-8;  // its square vanishes beside 1
constexpr double kSameStep = 1.0e-9;      // a clock's rounding is no new step

// How far a newton pushes a mass without a spring within dt_s:
//   y = (dt - (1 - e^-x) m/b) / b = dt^2/m (1/2 - x/6 + x^2/24 - ...),   x = b dt / m.
double compute_free_push(double mass, double damping, double dt_s, double s) noexcept {
    constexpr double kShort = 1.0e-3;  // below it the series' next term vanishes beside 1/2
    const double x = damping * dt_s / mass;
    if (x < kShort) {
        return dt_s * dt_s / mass * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x / 120.0)));
    }
    return (dt_s - s) / damping;
}

}  // namespace

OscillatorStep compute_oscillator_step(double mass, double stiffness, double damping,
                                       double dt_s) noexcept {
    const double alpha = 0.5 * damping / mass;
    const double square = stiffness / mass - alpha * alpha;
    const double w = std::sqrt(std::abs(square));
    // The head's c and s with the decay in them; near critical damping the series' first terms.
    const double decay = std::exp(-alpha * dt_s);
    double c = decay;
    double s = decay * dt_s;
    if (square < 0.0 && w * dt_s > kNearCritical) {
        // Two falling exponentials, alpha - w without the difference of two large numbers.
        const double slow = std::exp(-stiffness / mass / (alpha + w) * dt_s);
        const double fast = std::exp(-(alpha + w) * dt_s);
        c = 0.5 * (slow + fast);
        s = -0.5 * slow * std::expm1(-2.0 * w * dt_s) / w;
    } else if (w * dt_s > kNearCritical) {
        c = decay * std::cos(w * dt_s);
        s = decay * std::sin(w * dt_s) / w;
    }
    OscillatorStep step{c + alpha * s, s, -s * stiffness / mass, c - alpha * s, 0.0, s / mass};
    step.yf =
        stiffness > 0.0 ? (1.0 - step.yy) / stiffness : compute_free_push(mass, damping, dt_s, s);
    return step;
}

double find_stop_s(const AxisPlant& plant, double speed_m_per_s,
                   double acceleration_m_per_s2) noexcept {
    const double alpha = 0.5 * plant.damping_Ns_per_m / plant.mass_kg;
    const double square = plant.stiffness_N_per_m / plant.mass_kg - alpha * alpha;
    const double w = std::sqrt(std::abs(square));
    const double slope = acceleration_m_per_s2 + alpha * speed_m_per_s;
    // Near critical damping v(t) = e^(-alpha t) (v0 + slope t).
    const double straight_s =
        slope < 0.0 ? speed_m_per_s / -slope : std::numeric_limits<double>::infinity();
    if (w * straight_s < kNearCritical || w == 0.0) {
        return straight_s;
    }
    if (square > 0.0) {
        return std::atan2(speed_m_per_s * w, -slope) / w;
    }
    const double share = w * straight_s;
    return share < 1.0 ? std::atanh(share) / w : std::numeric_limits<double>::infinity();
}

const OscillatorStep& AxisMotion::know(double dt_s) noexcept {
    for (const Known& known : known_) {
        if (std::abs(dt_s - known.dt_s) <= kSameStep * dt_s) {
            return known.step;
        }
    }
    Known& place = known_[oldest_];
    oldest_ = 1 - oldest_;
    place = {dt_s, compute_oscillator_step(plant_.mass_kg, plant_.stiffness_N_per_m,
                                           plant_.damping_Ns_per_m, dt_s)};
    return place.step;
}

// Without friction, or with it as a part of the force.
void AxisMotion::slide(AxisState& state, double force_N, double dt_s) noexcept {
    const OscillatorStep& a = know(dt_s);
    state = {a.yy * state.position_m + a.yv * state.velocity_m_per_s + a.yf * force_N,
             a.vy * state.position_m + a.vv * state.velocity_m_per_s + a.vf * force_N};
}

void AxisMotion::step(AxisState& state, double force_N, double dt_s) noexcept {
    if (plant_.dry_friction_N == 0.0) {
        slide(state, force_N, dt_s);
        return;
    }
    double left_s = dt_s;
    while (left_s > 0.0) {
        // One piece: the way it goes or is driven, and the friction against it.
        const double drive_N = force_N - plant_.stiffness_N_per_m * state.position_m;
        const bool rests = state.velocity_m_per_s == 0.0;
        const double way = std::copysign(1.0, rests ? drive_N : state.velocity_m_per_s);
        const double slide_N = force_N - way * plant_.dry_friction_N;
        const double acceleration = (drive_N - way * plant_.dry_friction_N -
                                     plant_.damping_Ns_per_m * state.velocity_m_per_s) /
                                    plant_.mass_kg;
        if (rests && way * acceleration <= 0.0) {
            return;  // it sticks
        }
        const double stop_s =
            find_stop_s(plant_, std::abs(state.velocity_m_per_s), way * acceleration);
        if (stop_s > left_s) {
            slide(state, slide_N, left_s);
            return;
        }
        // It comes to rest within the step; the next piece begins there.
        const OscillatorStep to_rest = compute_oscillator_step(
            plant_.mass_kg, plant_.stiffness_N_per_m, plant_.damping_Ns_per_m, stop_s);
        state = {to_rest.yy * state.position_m + to_rest.yv * state.velocity_m_per_s +
                     to_rest.yf * slide_N,
                 0.0};
        left_s -= stop_s;
    }
}

}  // namespace fulcrum
