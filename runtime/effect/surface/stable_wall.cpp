#include "runtime/effect/surface/stable_wall.h"

#include "haptics/coupling/velocity_estimator.h"
#include "haptics/device/simulated/human_impedance.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace fulcrum::runtime {
namespace {

constexpr double kSlowest_per_s = 1.0;  // far below any hand's own swing
constexpr int kFrequencies = 400;       // to Nyquist: 2 % from one to the next at 1 kHz
constexpr double kStiffnessStep_N_per_m = 10.0;
constexpr double kDampingStep_Ns_per_m = 0.1;

// 1 over how far out L meets the negative real axis.
double compute_gain_margin(const CouplingSettings& wall, const HumanImpedance& hand,
                           const WallHolder& holder, double period_s) {
    using Complex = std::complex<double>;
    const double mass_kg = hand.mass_kg + holder.mass_kg;
    const double damping = hand.damping_Ns_per_m + holder.damping_Ns_per_m;
    const double delay_s = 0.5 * period_s + holder.link_s;
    const double velocity_s = 0.5 * kLongestWindow_s;
    const double fastest_per_s = std::numbers::pi / period_s;
    const double ratio = std::pow(fastest_per_s / kSlowest_per_s, 1.0 / kFrequencies);
    double farthest = 0.0;
    Complex before;
    double w = kSlowest_per_s;
    for (int i = 0; i <= kFrequencies; ++i, w *= ratio) {
        const Complex force =
            wall.stiffness_N_per_m * std::polar(1.0, -w * delay_s) +
            Complex(0.0, w * wall.damping_Ns_per_m) * std::polar(1.0, -w * (delay_s + velocity_s));
        const Complex now = force / Complex(hand.stiffness_N_per_m - mass_kg * w * w, w * damping);
        if (!std::isfinite(now.real()) || !std::isfinite(now.imag())) {
            return 0.0;  // a device that is no numbers holds nothing
        }
        if (i > 0 && (now.imag() < 0.0) != (before.imag() < 0.0)) {
            const double share = before.imag() / (before.imag() - now.imag());
            farthest = std::max(farthest, -std::lerp(before.real(), now.real(), share));
        }
        before = now;
    }
    return farthest > 0.0 ? 1.0 / farthest : std::numeric_limits<double>::infinity();
}

// Of the bare handle's vibration.
double compute_slew_margin(const CouplingSettings& wall, const WallHolder& holder,
                           const WallLoop& loop) {
    const double force_N = std::min(loop.max_force_N, holder.max_force_N);
    const double slew_per_s = 2.0 * loop.max_slew_N_per_s / force_N;
    return holder.mass_kg * slew_per_s * slew_per_s / wall.stiffness_N_per_m / kGainMargin;
}

// The same as a margin of 1, and done as soon as one hand shakes.
bool is_stable(const CouplingSettings& wall, const WallHolder& holder, const WallLoop& loop) {
    return compute_slew_margin(wall, holder, loop) >= 1.0 &&
           std::ranges::all_of(kHoldingHands, [&](const HumanImpedance& hand) {
               return compute_gain_margin(wall, hand, holder, 1.0 / loop.rate_hz) >= kGainMargin;
           });
}

double floor_to(double value, double step) {
    // A number that is a whole one but for rounding stays.
    return step * std::floor(value / step * (1.0 + 1.0e-12));
}

// The most damping of `wall`'s at most, with which it is stable; negative where none helps.
double find_damping(CouplingSettings wall, const WallHolder& holder, const WallLoop& loop) {
    constexpr int kParts = 32;
    const double wanted = wall.damping_Ns_per_m;
    for (int part = kParts; part >= 0; --part) {
        wall.damping_Ns_per_m = floor_to(wanted * part / kParts, kDampingStep_Ns_per_m);
        if (is_stable(wall, holder, loop)) {
            return wall.damping_Ns_per_m;
        }
    }
    return -1.0;
}

}  // namespace

WallHolder make_wall_holder(const DeviceTraits& traits, double link_s) {
    WallHolder holder;
    holder.name = traits.name;
    holder.mass_kg = traits.mass_kg > 0.0 ? traits.mass_kg : kHandleMass_kg;
    holder.damping_Ns_per_m = traits.damping_Ns_per_m;
    holder.max_force_N = traits.max_force_N;
    holder.link_s = link_s;
    return holder;
}

double compute_wall_margin(const CouplingSettings& wall, const WallHolder& holder,
                           const WallLoop& loop) {
    double margin = compute_slew_margin(wall, holder, loop);
    for (const HumanImpedance& hand : kHoldingHands) {
        margin = std::min(
            margin, compute_gain_margin(wall, hand, holder, 1.0 / loop.rate_hz) / kGainMargin);
    }
    return margin;
}

CouplingSettings fit_wall(const CouplingSettings& wanted, const WallHolder& holder,
                          const WallLoop& loop) {
    CouplingSettings wall = wanted;
    if (is_stable(wall, holder, loop)) {
        return wall;
    }
    // Softer walls are stable where stiffer ones are: by halves, in whole steps.
    long soft = 0;
    auto stiff = std::lround(std::ceil(wanted.stiffness_N_per_m / kStiffnessStep_N_per_m)) + 1;
    while (stiff - soft > 1) {
        const long middle = (soft + stiff) / 2;
        wall.stiffness_N_per_m = std::min(kStiffnessStep_N_per_m * static_cast<double>(middle),
                                          wanted.stiffness_N_per_m);
        (find_damping(wall, holder, loop) >= 0.0 ? soft : stiff) = middle;
    }
    wall.stiffness_N_per_m =
        std::min(kStiffnessStep_N_per_m * static_cast<double>(soft), wanted.stiffness_N_per_m);
    wall.damping_Ns_per_m = std::max(find_damping(wall, holder, loop), 0.0);
    return wall;
}

}  // namespace fulcrum::runtime
