#include "haptics/surface/texture.h"

#include "haptics/surface/relief.h"
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

TextureMap make_map(const Relief& relief, double height_m) {
    return {relief.map, relief.tile_u_m, relief.tile_v_m, height_m};
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

Texture::Texture(const TextureSettings& settings)
    : settings_(settings),
      map_([&] { return make_map(make_relief(settings), settings.height_m); }()) {
    if (const auto* sine = std::get_if<SineTexture>(&settings.source); sine != nullptr) {
        cos_ = std::cos(sine->direction_rad);
        sin_ = std::sin(sine->direction_rad);
    }
    // What is felt is made; the source is not needed any more.
    settings_.source = {};
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

HeightSample Texture::relief(const SurfaceVector& place) const noexcept {
    const SurfaceVector at = turn(place);
    HeightSample sample = map_.sample(0, at.u_m, at.v_m);
    const SurfaceVector slope = turn_back({sample.slope_u, sample.slope_v});
    sample.slope_u = slope.u_m;
    sample.slope_v = slope.v_m;
    return sample;
}

std::size_t Texture::memory_bytes() const noexcept {
    return sizeof(Texture) - sizeof(TextureMap) + map_.memory_bytes();
}

TextureFacts measure_texture(const TextureSettings& settings, double stiffness_N_per_m,
                             double force_N) {
    if (!settings.any() || !(stiffness_N_per_m > 0.0) || !(force_N > 0.0)) {
        return {};
    }
    const Texture texture(settings);
    const TextureMap& map = texture.map();
    const double depth_m = force_N / stiffness_N_per_m;
    double heights = 0.0;
    double squares = 0.0;
    double lateral = 0.0;
    for (std::int32_t j = 0; j < map.n_v(0); ++j) {
        for (std::int32_t i = 0; i < map.n_u(0); ++i) {
            const HeightSample relief =
                map.sample(0, map.tile_u_m() * i / map.n_u(0), map.tile_v_m() * j / map.n_v(0));
            const SurfaceVector along =
                compute_texture_offset(texture.settings(), relief, depth_m).along;
            heights += relief.height_m;
            squares += relief.height_m * relief.height_m;
            lateral += along.u_m * along.u_m + along.v_m * along.v_m;
        }
    }
    const double n = static_cast<double>(map.n_u(0)) * map.n_v(0);
    return {std::sqrt(std::max(squares / n - (heights / n) * (heights / n), 0.0)),
            std::sqrt(lateral / n) / depth_m};
}

}  // namespace fulcrum
