// The step path of wind.h.
#include "haptics/flight/wind.h"

#include "haptics/math/split_mix.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

constexpr double kReference_m = 10.0;  // where meteorologists measure
constexpr double kFoot_m = 0.3048;
constexpr double kLowest_ft = 10.0;  // between them the specification's formulas hold
constexpr double kHighest_ft = 1000.0;
constexpr double kGustReference_m = 20.0 * kFoot_m;
constexpr double kSlowest_m_per_s = 0.1;  // at which gusts drift past: below it they stand

// 0 to 1, both excluded: the n-th of a seed, each seed's begin elsewhere.
double compute_chance(std::uint64_t seed, std::uint64_t n) noexcept {
    constexpr double kHalfStep = 0x1.0p-54;
    return to_chance(compute_split_mix(seed * 0xd1342543de82ef95U + (n + 1) * kSplitMixGamma)) +
           kHalfStep;
}

// Two normally distributed numbers (Box, Muller 1958).
std::array<double, 2> draw_normal(std::uint64_t seed, std::uint64_t& n_drawn) noexcept {
    const double radius = std::sqrt(-2.0 * std::log(compute_chance(seed, n_drawn)));
    const double angle_rad = 2.0 * std::numbers::pi * compute_chance(seed, n_drawn + 1);
    n_drawn += 2;
    return {radius * std::cos(angle_rad), radius * std::sin(angle_rad)};
}

// Both filters by one step of `share` of their time, driven by two normal numbers.
void step_filters(double share, const std::array<double, 2>& noise, double& first,
                  double& second) noexcept {
    const double a = std::exp(-share);
    // The noise's covariance, and its Cholesky factors.
    const double c11 = 1.0 - a * a;
    const double c21 = 0.5 - a * a * (share + 0.5);
    const double c22 = 0.5 - a * a * (share * share + share + 0.5);
    const double l11 = std::sqrt(c11);
    const double l21 = l11 > 0.0 ? c21 / l11 : 0.0;
    const double l22 = std::sqrt(std::max(c22 - l21 * l21, 0.0));
    second = a * second + share * a * first + l21 * noise[0] + l22 * noise[1];
    first = a * first + l11 * noise[0];
}

}  // namespace

double compute_mean_wind_m_per_s(const WindSettings& settings, double height_m) noexcept {
    const double z_m = settings.roughness_m;
    const double above_m = std::max(height_m, 0.0);
    return settings.speed_m_per_s * std::log((above_m + z_m) / z_m) /
           std::log((kReference_m + z_m) / z_m);
}

GustScale compute_gust_scale(const WindSettings& settings, double height_m) noexcept {
    const double height_ft = std::clamp(height_m / kFoot_m, kLowest_ft, kHighest_ft);
    const double shape = 0.177 + 0.000823 * height_ft;
    const double up_m_per_s =
        settings.gustiness * 0.1 * compute_mean_wind_m_per_s(settings, kGustReference_m);
    const double along_m_per_s = up_m_per_s / std::pow(shape, 0.4);
    const double up_m = height_ft * kFoot_m;
    const double along_m = up_m / std::pow(shape, 1.2);
    return {{along_m_per_s, along_m_per_s, up_m_per_s}, {along_m, along_m, up_m}};
}

void step_gusts(const WindSettings& settings, double height_m, double dt_s,
                GustState& gusts) noexcept {
    if (!(dt_s > 0.0) || !std::isfinite(dt_s) || !(settings.gustiness > 0.0)) {
        return;
    }
    const GustScale scale = compute_gust_scale(settings, height_m);
    const double past_m =
        dt_s * std::max(compute_mean_wind_m_per_s(settings, height_m), kSlowest_m_per_s);
    for (Index i = 0; i < 3; ++i) {
        step_filters(past_m / scale.length_m[i], draw_normal(settings.seed, gusts.n_drawn),
                     gusts.first[i], gusts.second[i]);
    }
    constexpr double kRoot3 = std::numbers::sqrt3;
    Vector3 gust = (kRoot3 * gusts.first + (1.0 - kRoot3) * gusts.second) / std::numbers::sqrt2;
    gust.x() = gusts.first.x();
    gust = gust.cwiseProduct(scale.strength_m_per_s);
    const Vector3 across_W = Vector3::UnitY().cross(settings.downwind_W);
    gusts.velocity_W =
        gust.x() * settings.downwind_W + gust.y() * across_W + gust.z() * Vector3::UnitY();
}

Vector3 compute_wind_W(const WindSettings& settings, const GustState& gusts,
                       const Vector3& place_W) noexcept {
    const double height_m = place_W.y() - settings.ground_m;
    return compute_mean_wind_m_per_s(settings, height_m) * settings.downwind_W + gusts.velocity_W;
}

}  // namespace fulcrum
