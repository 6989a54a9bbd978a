// The step path of texture_map.h.
#include "haptics/surface/texture_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {
namespace {

// The four B-splines that are not zero at a fraction t of the way from one sample to the next, and their derivatives.
struct SplineWeights {
    std::array<double, 4> value;
    std::array<double, 4> slope;
};
SplineWeights compute_weights(double t) noexcept {
    const double s = 1.0 - t;
    return {{s * s * s / 6.0, (4.0 - 3.0 * t * t * (1.0 + s)) / 6.0,
             (4.0 - 3.0 * s * s * (1.0 + t)) / 6.0, t * t * t / 6.0},
            {-0.5 * s * s, t * (1.5 * t - 2.0), s * (2.0 - 1.5 * s), 0.5 * t * t}};
}

// Four neighbouring samples on a circle of n, and the fraction between the two in the middle.
struct Neighbours {
    std::array<std::size_t, 4> index;
    double fraction;
};
Neighbours find_neighbours(double x, std::int32_t n) noexcept {
    const double round = x - std::floor(x / n) * n;  // 0 to n
    const double below = std::min(std::floor(round), n - 1.0);
    Neighbours found{{}, round - below};
    auto i = static_cast<std::int32_t>(below) + n - 1;
    for (std::size_t& index : found.index) {
        index = static_cast<std::size_t>(i % n);
        ++i;
    }
    return found;
}

}  // namespace

HeightSample TextureMap::sample(std::size_t level, double u_m, double v_m) const noexcept {
    if (!std::isfinite(u_m) || !std::isfinite(v_m)) {
        return {};
    }
    const Level& grid = levels_[level];
    const Neighbours u = find_neighbours(u_m * grid.per_u, grid.n_u);
    const Neighbours v = find_neighbours(v_m * grid.per_v, grid.n_v);
    const SplineWeights wu = compute_weights(u.fraction);
    const SplineWeights wv = compute_weights(v.fraction);
    HeightSample sum;
    for (std::size_t j = 0; j < 4; ++j) {
        const float* row = grid.c.data() + v.index[j] * static_cast<std::size_t>(grid.n_u);
        double height = 0.0;
        double slope = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto c = static_cast<double>(row[u.index[i]]);
            height += wu.value[i] * c;
            slope += wu.slope[i] * c;
        }
        sum.height_m += wv.value[j] * height;
        sum.slope_u += wv.value[j] * slope * grid.per_u;
        sum.slope_v += wv.slope[j] * height * grid.per_v;
    }
    return sum;
}

double TextureMap::count_samples(std::size_t level, double u_m, double v_m) const noexcept {
    return std::hypot(u_m * levels_[level].per_u, v_m * levels_[level].per_v);
}

}  // namespace fulcrum
