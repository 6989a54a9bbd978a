#include "haptics/surface/relief.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <random>

namespace fulcrum {
namespace {

constexpr std::int32_t kWaveSamples = 32;
constexpr double kTileWaves = 4.0;      // of the longest, in a tile of bumps
constexpr double kFinestSamples = 4.0;  // of the shortest
constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kEndless_m = 1.0e9;  // along a groove nothing changes

Relief make(const std::monostate& /*none*/) {
    return {{1, 1, {0.0F}}, 1.0, 1.0, 0.0};
}

Relief make(const ImageTexture& image) {
    return {*image.map, image.tile_u_m, image.tile_v_m, 0.0};
}

Relief make(const SineTexture& sine) {
    Relief relief{{kWaveSamples, 1, {}}, sine.wavelength_m, kEndless_m, sine.direction_rad};
    for (std::int32_t i = 0; i < kWaveSamples; ++i) {
        relief.map.heights.push_back(
            static_cast<float>(0.5 + 0.5 * std::sin(kTwoPi * i / kWaveSamples)));
    }
    return relief;
}

// Adds cos(2 pi (i u + j v) + phase) on n x n samples: the product of a phasor of the column and one of the row.
void add_wave(std::int32_t n, double i, double j, double phase, std::vector<double>& heights) {
    std::vector<std::complex<double>> along(static_cast<std::size_t>(n));
    for (std::int32_t u = 0; u < n; ++u) {
        along[static_cast<std::size_t>(u)] = std::polar(1.0, kTwoPi * i * u / n + phase);
    }
    for (std::int32_t v = 0; v < n; ++v) {
        const std::complex<double> across = std::polar(1.0, kTwoPi * j * v / n);
        double* row = heights.data() + static_cast<std::ptrdiff_t>(v) * n;
        for (std::size_t u = 0; u < along.size(); ++u) {
            row[u] += along[u].real() * across.real() - along[u].imag() * across.imag();
        }
    }
}

Relief make(const NoiseTexture& noise) {
    const double tile_m = kTileWaves * noise.longest_m;
    const double finest = tile_m / noise.shortest_m;  // waves of the shortest in a tile
    std::int32_t n = 16;
    while (n < kFinestSamples * finest) {
        n *= 2;
    }
    std::mt19937_64 random(noise.seed);
    const auto uniform = [&random] {
        return std::ldexp(static_cast<double>(random() >> 11U), -53);
    };
    std::vector<double> heights(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), 0.0);
    for (int k = 0; k < kBumpWaves; ++k) {
        const double waves = kTileWaves * std::pow(finest / kTileWaves, uniform());
        const double direction = kTwoPi * uniform();
        const double phase = kTwoPi * uniform();
        add_wave(n, std::round(waves * std::cos(direction)),
                 std::round(waves * std::sin(direction)), phase, heights);
    }
    const auto [low, high] = std::ranges::minmax(heights);
    Relief relief{{n, n, {}}, tile_m, tile_m, 0.0};
    relief.map.heights.reserve(heights.size());
    for (const double height : heights) {
        relief.map.heights.push_back(
            std::clamp(static_cast<float>((height - low) / (high - low)), 0.0F, 1.0F));
    }
    return relief;
}

}  // namespace

Relief make_relief(const TextureSettings& settings) {
    return std::visit([](const auto& source) { return make(source); }, settings.source);
}

}  // namespace fulcrum
