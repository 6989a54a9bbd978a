// The load path of texture.h.
#include "haptics/surface/relief.h"
#include "haptics/surface/texture.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// Beside a sharp edge a spline swings beyond its samples, by a quarter of the step and more. Then all heights are drawn together,
// so that the relief is from 0 to height_m high as its settings say.
TextureMap make_map(const Relief& relief, double height_m) {
    constexpr double kRounding = 1.0e-6;  // of floats: no swing
    TextureMap map(relief.map, relief.tile_u_m, relief.tile_v_m, height_m);
    const TextureMap::Extremes seen = map.find_extremes();
    const double low_m = std::min(seen.low_m, 0.0);
    const double span_m = std::max(seen.high_m, height_m) - low_m;
    if (span_m > height_m * (1.0 + kRounding)) {
        map.rescale(height_m / span_m, -low_m * height_m / span_m);
    }
    return map;
}

}  // namespace

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
