// The load path of god_texture.h.
#include "haptics/tool/god_texture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum {
namespace {

double find_slope_change(const HeightSample& a, const HeightSample& b) {
    return std::hypot(b.slope_u - a.slope_u, b.slope_v - a.slope_v);
}

}  // namespace

ReliefSteepness find_steepness(const TextureMap& map) {
    const double step_u_m = map.tile_u_m() / map.n_u(0);
    const double step_v_m = map.tile_v_m() / map.n_v(0);
    ReliefSteepness seen;
    for (std::int32_t j = 0; j < map.n_v(0); ++j) {
        HeightSample before = map.sample(0, -step_u_m, j * step_v_m);
        for (std::int32_t i = 0; i < map.n_u(0); ++i) {
            const HeightSample here = map.sample(0, i * step_u_m, j * step_v_m);
            const HeightSample above = map.sample(0, i * step_u_m, (j + 1) * step_v_m);
            const double along_u = find_slope_change(before, here) / step_u_m;
            const double along_v = find_slope_change(here, above) / step_v_m;
            seen.curvature_per_m = std::max({seen.curvature_per_m, along_u, along_v});
            seen.slope = std::max(seen.slope, std::hypot(here.slope_u, here.slope_v));
            before = here;
        }
    }
    // Half-way between two samples it may be steeper by what half of the way bends it.
    seen.slope += 0.5 * std::min(step_u_m, step_v_m) * seen.curvature_per_m;
    return seen;
}

GodTexture::GodTexture(std::shared_ptr<const Texture> texture, const GodTextureSettings& settings)
    : texture_(std::move(texture)),
      settings_(settings),
      steepness_(find_steepness(texture_->map())) {}

}  // namespace fulcrum
