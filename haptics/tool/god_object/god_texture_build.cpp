// The load path of god_texture.h.
#include "haptics/tool/god_object/god_texture.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace fulcrum {
namespace {

double find_slope_change(const HeightSample& a, const HeightSample& b) {
    return std::hypot(b.slope_u - a.slope_u, b.slope_v - a.slope_v);
}

}  // namespace

// At the samples and half-way between them: from one sample to the next a spline's slope bends to and fro once at most, and where the samples go up
// and down in turn it is level at each of them.
ReliefSteepness find_steepness(const TextureMap& map) {
    const int n_u = 2 * map.n_u(0);
    const int n_v = 2 * map.n_v(0);
    const double step_u_m = map.tile_u_m() / n_u;
    const double step_v_m = map.tile_v_m() / n_v;
    ReliefSteepness seen;
    double change_u = 0.0;
    double change_v = 0.0;
    std::vector<HeightSample> below(static_cast<std::size_t>(n_u));
    for (int j = -1; j < n_v; ++j) {
        HeightSample before = map.sample(0, -step_u_m, j * step_v_m);
        for (int i = 0; i < n_u; ++i) {
            const HeightSample here = map.sample(0, i * step_u_m, j * step_v_m);
            HeightSample& under = below[static_cast<std::size_t>(i)];
            change_u = std::max(change_u, find_slope_change(before, here));
            change_v = j < 0 ? 0.0 : std::max(change_v, find_slope_change(under, here));
            seen.slope = std::max(seen.slope, std::hypot(here.slope_u, here.slope_v));
            before = under = here;
        }
    }
    seen.curvature_per_m = std::max(change_u / step_u_m, change_v / step_v_m);
    // In the middle between two of these it may be steeper by what half of the way to either side bends it.
    seen.slope += 0.5 * (change_u + change_v);
    return seen;
}

GodTexture::GodTexture(std::shared_ptr<const Texture> texture, const GodTextureSettings& settings)
    : texture_(std::move(texture)),
      settings_(settings),
      steepness_(find_steepness(texture_->map())) {}

}  // namespace fulcrum
