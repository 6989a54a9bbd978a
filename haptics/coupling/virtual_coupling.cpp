#include "haptics/coupling/virtual_coupling.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

constexpr double kMaxStiffness_N_per_m = 1.0e5;  // twenty times the stiffest arm
constexpr double kMaxDamping_Ns_per_m = 1.0e3;

// NaN fails every comparison, so it is refused with the rest.
bool is_within(double value, double low, double high) {
    return value >= low && value <= high;
}

// The Hermite between linear and constant, on u in [0, 1], with D the rise and g = k (s2 - s1):
//   f = f1 + g u + (3 D - 2 g) u^2 + (g - 2 D) u^3
struct Blend {
    double width_m, u;
    double start_N;           // f1
    double slope_N;           // g
    double square_N, cube_N;  // the two last coefficients
};
Blend blend_at(const CouplingSettings& settings, double stretch_m) noexcept {
    const double width_m = settings.saturation_range_m - settings.linear_range_m;
    const double start_N = settings.stiffness_N_per_m * settings.linear_range_m;
    const double rise_N = settings.saturation_force_N - start_N;
    const double slope_N = settings.stiffness_N_per_m * width_m;
    return {width_m,
            (stretch_m - settings.linear_range_m) / width_m,
            start_N,
            slope_N,
            3.0 * rise_N - 2.0 * slope_N,
            slope_N - 2.0 * rise_N};
}

Expected<void> validate_saturation(const CouplingSettings& settings) {
    const double rise_N =
        settings.saturation_force_N - settings.stiffness_N_per_m * settings.linear_range_m;
    const double width_m = settings.saturation_range_m - settings.linear_range_m;
    if (!(settings.linear_range_m >= 0.0) || !(width_m > 0.0) ||
        !std::isfinite(settings.saturation_range_m)) {
        return fail("the coupling's saturation range does not lie above its linear range", {},
                    "give 0 <= linear_range_m < saturation_range_m");
    }
    if (!(kSteepestStart * rise_N >= settings.stiffness_N_per_m * width_m) ||
        !std::isfinite(rise_N)) {
        return fail("the coupling's force would fall before it saturates", {},
                    "raise saturation_force_N or narrow the range of the blend");
    }
    return {};
}

}  // namespace

Expected<void> validate(const CouplingSettings& settings) {
    if (!is_within(settings.stiffness_N_per_m, 0.0, kMaxStiffness_N_per_m)) {
        return fail("the coupling's stiffness is out of range", {}, "choose 0 to 1e5 N/m");
    }
    if (!is_within(settings.damping_Ns_per_m, 0.0, kMaxDamping_Ns_per_m)) {
        return fail("the coupling's damping is out of range", {}, "choose 0 to 1e3 Ns/m");
    }
    if (settings.linear_range_m == 0.0 && settings.saturation_range_m == 0.0 &&
        settings.saturation_force_N == 0.0) {
        return {};
    }
    return validate_saturation(settings);
}

CouplingSettings saturate(const CouplingSettings& settings, double linear_range_m,
                          double force_N) noexcept {
    CouplingSettings saturating = settings;
    const double rise_N = force_N - settings.stiffness_N_per_m * linear_range_m;
    saturating.linear_range_m = linear_range_m;
    saturating.saturation_range_m = linear_range_m + 1.5 * rise_N / settings.stiffness_N_per_m;
    saturating.saturation_force_N = force_N;
    return saturating;
}

double compute_spring_force_N(const CouplingSettings& settings, double stretch_m) noexcept {
    if (!settings.saturates() || stretch_m <= settings.linear_range_m) {
        return settings.stiffness_N_per_m * stretch_m;
    }
    if (stretch_m >= settings.saturation_range_m) {
        return settings.saturation_force_N;
    }
    const Blend b = blend_at(settings, stretch_m);
    return b.start_N + b.u * (b.slope_N + b.u * (b.square_N + b.u * b.cube_N));
}

double compute_spring_slope_N_per_m(const CouplingSettings& settings, double stretch_m) noexcept {
    if (!settings.saturates() || stretch_m <= settings.linear_range_m) {
        return settings.stiffness_N_per_m;
    }
    if (stretch_m >= settings.saturation_range_m) {
        return 0.0;
    }
    // The derivative of the cubic by u, over the width: du/ds = 1 / width.
    const Blend b = blend_at(settings, stretch_m);
    return (b.slope_N + b.u * (2.0 * b.square_N + 3.0 * b.u * b.cube_N)) / b.width_m;
}

double compute_spring_energy_J(const CouplingSettings& settings, double stretch_m) noexcept {
    const double linear_m =
        settings.saturates() ? std::min(stretch_m, settings.linear_range_m) : stretch_m;
    double energy_J = 0.5 * settings.stiffness_N_per_m * linear_m * linear_m;
    if (!(stretch_m > linear_m)) {
        return energy_J;
    }
    // The cubic's integral, term by term:  w (f1 u + g u^2/2 + (3 D - 2 g) u^3/3 + (g - 2 D) u^4/4)
    const Blend b = blend_at(settings, std::min(stretch_m, settings.saturation_range_m));
    energy_J +=
        b.width_m * b.u *
        (b.start_N + b.u * (0.5 * b.slope_N + b.u * (b.square_N / 3.0 + b.u * 0.25 * b.cube_N)));
    return energy_J +
           settings.saturation_force_N * std::max(stretch_m - settings.saturation_range_m, 0.0);
}

Vector3 compute_coupling_spring(const CouplingSettings& settings, const Vector3& proxy_W,
                                const Vector3& hand_W) noexcept {
    const Vector3 stretch_W = proxy_W - hand_W;
    const double stretch_m = compute_length(stretch_W);
    if (!(stretch_m > 0.0)) {
        return Vector3::Zero();
    }
    return stretch_W * (compute_spring_force_N(settings, stretch_m) / stretch_m);
}

}  // namespace fulcrum
