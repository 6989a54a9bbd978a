// The load path of texture_map.h.
#include "haptics/surface/texture_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace fulcrum {
namespace {

const double kPole = std::numbers::sqrt3 - 2.0;
constexpr double kLobes = 3.0;

double sinc(double x) {
    const double y = std::numbers::pi * x;
    return y == 0.0 ? 1.0 : std::sin(y) / y;
}
double lanczos(double x) {
    return std::abs(x) < kLobes ? sinc(x) * sinc(x / kLobes) : 0.0;
}

// A grid of doubles, on whose rows and columns a function of one period works.
struct Grid {
    std::size_t n_u;
    std::size_t n_v;
    std::vector<double> at;
};

template <class Function>
Grid map_rows(const Grid& grid, std::size_t n_out, Function function) {
    Grid out{n_out, grid.n_v, std::vector<double>(n_out * grid.n_v)};
    std::vector<double> row(grid.n_u);
    for (std::size_t v = 0; v < grid.n_v; ++v) {
        std::copy_n(grid.at.begin() + static_cast<std::ptrdiff_t>(v * grid.n_u), grid.n_u,
                    row.begin());
        const std::vector<double> made = function(row);
        std::ranges::copy(made, out.at.begin() + static_cast<std::ptrdiff_t>(v * n_out));
    }
    return out;
}

Grid transpose(const Grid& grid) {
    Grid out{grid.n_v, grid.n_u, std::vector<double>(grid.at.size())};
    for (std::size_t v = 0; v < grid.n_v; ++v) {
        for (std::size_t u = 0; u < grid.n_u; ++u) {
            out.at[u * grid.n_v + v] = grid.at[v * grid.n_u + u];
        }
    }
    return out;
}

Grid shrink(const Grid& grid) {
    const auto half = [](std::size_t n) { return std::max<std::size_t>((n + 1) / 2, 1); };
    const auto along = [&half](const Grid& one) {
        const std::size_t n = half(one.n_u);
        return map_rows(one, n,
                        [n](const std::vector<double>& row) { return resample_periodic(row, n); });
    };
    return transpose(along(transpose(along(grid))));
}

}  // namespace

std::vector<double> resample_periodic(const std::vector<double>& samples, std::size_t n_out) {
    const auto n_in = static_cast<std::ptrdiff_t>(samples.size());
    const double step = static_cast<double>(n_in) / static_cast<double>(n_out);
    const double width = std::max(step, 1.0);
    std::vector<double> out(n_out);
    for (std::size_t k = 0; k < n_out; ++k) {
        const double x = static_cast<double>(k) * step;
        double sum = 0.0;
        double weights = 0.0;
        const auto first = static_cast<std::ptrdiff_t>(std::ceil(x - kLobes * width));
        const auto last = static_cast<std::ptrdiff_t>(std::floor(x + kLobes * width));
        for (std::ptrdiff_t i = first; i <= last; ++i) {
            const double weight = lanczos((static_cast<double>(i) - x) / width);
            sum += weight * samples[static_cast<std::size_t>(((i % n_in) + n_in) % n_in)];
            weights += weight;
        }
        out[k] = sum / weights;
    }
    return out;
}

// (c_(i-1) + 4 c_i + c_(i+1)) / 6 = s_i factors into one recursion up and one down, each with the pole z; on a circle of n
// the first value of each is the whole circle's sum, sum_k z^k s_(i-k) / (1 - z^n).
std::vector<double> compute_spline_coefficients(const std::vector<double>& samples) {
    std::vector<double> c = samples;
    const std::size_t n = c.size();
    const double whole = 1.0 / (1.0 - std::pow(kPole, static_cast<double>(n)));
    const auto run = [&](auto at) {
        double sum = 0.0;
        double power = 1.0;
        for (std::size_t k = 0; k < n; ++k) {
            sum += power * at((n - k) % n);
            power *= kPole;
        }
        at(0) = sum * whole;
        for (std::size_t i = 1; i < n; ++i) {
            at(i) += kPole * at(i - 1);
        }
    };
    run([&c](std::size_t i) -> double& { return c[i]; });
    run([&c, n](std::size_t i) -> double& { return c[n - 1 - i]; });
    for (double& one : c) {
        one *= -6.0 * kPole;
    }
    return c;
}

TextureMap::TextureMap(const HeightMap& map, double tile_u_m, double tile_v_m, double height_m)
    : tile_u_m_(tile_u_m), tile_v_m_(tile_v_m) {
    Grid grid{static_cast<std::size_t>(map.n_u), static_cast<std::size_t>(map.n_v), {}};
    grid.at.reserve(map.heights.size());
    for (const float height : map.heights) {
        grid.at.push_back(height_m * static_cast<double>(height));
    }
    for (;;) {
        Level level = make_level(grid.at, static_cast<std::int32_t>(grid.n_u),
                                 static_cast<std::int32_t>(grid.n_v));
        level.per_u = level.n_u / tile_u_m;
        level.per_v = level.n_v / tile_v_m;
        levels_.push_back(std::move(level));
        if (grid.n_u == 1 && grid.n_v == 1) {
            return;
        }
        grid = shrink(grid);
    }
}

TextureMap::Level TextureMap::make_level(std::vector<double> heights_m, std::int32_t n_u,
                                         std::int32_t n_v) {
    const auto along = [](const Grid& grid) {
        return map_rows(grid, grid.n_u, compute_spline_coefficients);
    };
    const Grid samples{static_cast<std::size_t>(n_u), static_cast<std::size_t>(n_v),
                       std::move(heights_m)};
    const Grid c = transpose(along(transpose(along(samples))));
    Level level;
    level.n_u = n_u;
    level.n_v = n_v;
    level.c.assign(c.at.begin(), c.at.end());
    return level;
}

// Row by row: the coefficients' rows joined at a sample or half-way to the next, then the same along the row.
TextureMap::Extremes TextureMap::find_extremes() const {
    const Level& grid = levels_.front();
    const auto n_u = static_cast<std::size_t>(grid.n_u);
    const auto n_v = static_cast<std::size_t>(grid.n_v);
    constexpr std::array<std::array<float, 4>, 2> kWeights{
        {{1.0F / 6.0F, 4.0F / 6.0F, 1.0F / 6.0F, 0.0F},
         {1.0F / 48.0F, 23.0F / 48.0F, 23.0F / 48.0F, 1.0F / 48.0F}}};
    Extremes found{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
    std::vector<float> row(n_u + 3);  // with those beyond both ends
    for (std::size_t j = 0; j < 2 * n_v; ++j) {
        const auto& across = kWeights[j % 2];
        std::ranges::fill(row, 0.0F);
        for (std::size_t k = 0; k < 4; ++k) {
            const float* c = grid.c.data() + (j / 2 + n_v + k - 1) % n_v * n_u;
            for (std::size_t i = 0; i < n_u; ++i) {
                row[i + 1] += across[k] * c[i];
            }
        }
        row[0] = row[n_u];
        row[n_u + 1] = row[1];
        row[n_u + 2] = row[n_u > 1 ? 2 : 1];
        for (const auto& along : kWeights) {
            for (std::size_t i = 0; i < n_u; ++i) {
                const auto here_m =
                    static_cast<double>(along[0] * row[i] + along[1] * row[i + 1] +
                                        along[2] * row[i + 2] + along[3] * row[i + 3]);
                found.low_m = std::min(found.low_m, here_m);
                found.high_m = std::max(found.high_m, here_m);
            }
        }
    }
    return found;
}

// The splines' weights sum to 1 everywhere: what is done to all coefficients is done to all heights.
void TextureMap::rescale(double factor, double offset_m) {
    for (Level& level : levels_) {
        for (float& c : level.c) {
            c = static_cast<float>(factor * static_cast<double>(c) + offset_m);
        }
    }
}

std::size_t TextureMap::memory_bytes() const noexcept {
    std::size_t bytes = sizeof(TextureMap) + levels_.capacity() * sizeof(Level);
    for (const Level& level : levels_) {
        bytes += level.c.capacity() * sizeof(float);
    }
    return bytes;
}

}  // namespace fulcrum
