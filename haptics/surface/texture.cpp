// The step path of texture.h.
#include "haptics/surface/texture.h"

#include "haptics/surface/stroke_filter.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace fulcrum {
namespace {

// Waves a round of what is still sampled: those of a product of two heights are twice as short as the relief's.
constexpr double kMostWaves = kMostPerRound - kStrokeStop;

void add(TextureOffset& sum, double weight, const TextureOffset& one) noexcept {
    sum.normal_m += weight * one.normal_m;
    sum.along.u_m += weight * one.along.u_m;
    sum.along.v_m += weight * one.along.v_m;
    sum.height_m += weight * one.height_m;
}

}  // namespace

TextureOffset compute_texture_offset(const TextureSettings& settings, const HeightSample& relief,
                                     double depth_m) noexcept {
    // How much of the slope is felt, metres, and how much of the depth is not.
    double lean_m = 0.0;
    double lost_m = 0.0;
    switch (settings.law) {
        case TextureLaw::perturbed_normal:
            lean_m = std::min(depth_m, settings.gain * relief.height_m);
            break;
        case TextureLaw::lateral:
            lean_m = settings.gain * depth_m;
            break;
        case TextureLaw::height_offset:
            lost_m =
                std::clamp(settings.gain * (settings.height_m - relief.height_m), 0.0, depth_m);
            lean_m = settings.gain * (depth_m - lost_m);
            break;
    }
    return {-lost_m, {-lean_m * relief.slope_u, -lean_m * relief.slope_v}, relief.height_m};
}

// The finest level of which a round passes few enough samples.
std::size_t Texture::choose_level(const SurfaceVector& stroke) const noexcept {
    std::size_t level = 0;
    while (level + 1 < map_.n_levels() &&
           map_.count_samples(level, stroke.u_m, stroke.v_m) > kMostWaves) {
        ++level;
    }
    return level;
}

TextureOffset Texture::feel(const SurfaceVector& place, const SurfaceVector& stroke,
                            double depth_m) const noexcept {
    const SurfaceVector at = turn(place);
    const SurfaceVector way = turn(stroke);
    if (!std::isfinite(way.u_m) || !std::isfinite(way.v_m) || !(depth_m >= 0.0)) {
        return {};
    }
    const std::size_t level = choose_level(way);
    // Of a relief with a wave every two samples, its square has one a sample.
    const int m = choose_samples_per_round(map_.count_samples(level, way.u_m, way.v_m));
    TextureOffset felt;
    if (m == 0) {
        felt = compute_texture_offset(settings_, map_.sample(level, at.u_m, at.v_m), depth_m);
    } else {
        const std::span<const double> weights = stroke_weights(m);
        double rounds = -kStrokeReach;
        for (const double weight : weights) {
            const HeightSample relief =
                map_.sample(level, at.u_m + rounds * way.u_m, at.v_m + rounds * way.v_m);
            add(felt, weight, compute_texture_offset(settings_, relief, depth_m));
            rounds += 1.0 / m;
        }
    }
    // Ripple must not make a pull of a push.
    felt.normal_m = std::clamp(felt.normal_m, -depth_m, 0.0);
    felt.along = turn_back(felt.along);
    return felt;
}

double Texture::bump_m2(double depth_m) const noexcept {
    const double felt_m = settings_.gain * settings_.height_m;
    return settings_.law == TextureLaw::perturbed_normal
               ? std::min(depth_m, felt_m) * settings_.height_m
               : depth_m * felt_m;
}

HeightSample Texture::relief(const SurfaceVector& place) const noexcept {
    const SurfaceVector at = turn(place);
    HeightSample sample = map_.sample(0, at.u_m, at.v_m);
    const SurfaceVector slope = turn_back({sample.slope_u, sample.slope_v});
    sample.slope_u = slope.u_m;
    sample.slope_v = slope.v_m;
    return sample;
}

}  // namespace fulcrum
