#include "haptics/surface/relief.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

using namespace fulcrum;

namespace {

TextureSettings with(const TextureSource& source) {
    TextureSettings settings;
    settings.source = source;
    return settings;
}

// Power of the waves (i, j) of an n x n map, by a transform of each row and then each column.
double power_at(const HeightMap& map, int i, int j) {
    const double turn = -2.0 * std::numbers::pi;
    std::complex<double> sum = 0.0;
    for (std::int32_t v = 0; v < map.n_v; ++v) {
        std::complex<double> row = 0.0;
        for (std::int32_t u = 0; u < map.n_u; ++u) {
            row += static_cast<double>(
                       map.heights[static_cast<std::size_t>(v) * static_cast<std::size_t>(map.n_u) +
                                   static_cast<std::size_t>(u)]) *
                   std::polar(1.0, turn * i * u / map.n_u);
        }
        sum += row * std::polar(1.0, turn * j * v / map.n_v);
    }
    return std::norm(sum);
}

}  // namespace

TEST_CASE("relief: grooves are one wave from 0 to 1, without an end along the groove") {
    const Relief relief = make_relief(with(SineTexture{0.003, 0.7}));
    CHECK(relief.tile_u_m == 0.003);
    CHECK(relief.tile_v_m > 1.0e6);
    CHECK(relief.turn_rad == 0.7);
    CHECK(relief.map.n_v == 1);
    const auto [low, high] = std::ranges::minmax(relief.map.heights);
    CHECK(low == 0.0F);
    CHECK(high == 1.0F);
    CHECK(relief.map.heights.front() == 0.5F);
    CHECK(validate(with(ImageTexture{std::make_shared<const HeightMap>(relief.map), 1.0, 1.0})));
}

TEST_CASE("relief: an image is taken as it is") {
    const auto map = std::make_shared<const HeightMap>(HeightMap{2, 1, {0.25F, 1.0F}});
    const Relief relief = make_relief(with(ImageTexture{map, 0.1, 0.2}));
    CHECK(relief.map.heights == map->heights);
    CHECK(relief.tile_u_m == 0.1);
    CHECK(relief.tile_v_m == 0.2);
}

TEST_CASE("relief: bumps have waves of the band and no other") {
    const NoiseTexture noise{0.001, 0.003, 5};
    const Relief relief = make_relief(with(noise));
    CHECK(relief.tile_u_m == Approx(4.0 * noise.longest_m));
    REQUIRE(relief.map.n_u == 64);  // 12 of the shortest waves, 4 samples each at least
    double inside = 0.0;
    double outside = 0.0;
    for (int i = -16; i <= 16; ++i) {
        for (int j = 0; j <= 16; ++j) {
            const double waves = std::hypot(i, j);
            // Rounding to whole waves in the tile moves each by 0.71 at most.
            const bool in_band = waves > 4.0 - 0.71 && waves < 12.0 + 0.71;
            (in_band ? inside : outside) += i == 0 && j == 0 ? 0.0 : power_at(relief.map, i, j);
        }
    }
    CHECK(outside < 1.0e-9 * inside);  // heights are in single precision
    const auto [low, high] = std::ranges::minmax(relief.map.heights);
    CHECK(low == 0.0F);
    CHECK(high == 1.0F);
}

TEST_CASE("relief: the same seed gives the same bumps, another one others") {
    const auto heights = [](std::uint32_t seed) {
        return make_relief(with(NoiseTexture{0.001, 0.002, seed})).map.heights;
    };
    CHECK(heights(3) == heights(3));
    CHECK(heights(3) != heights(4));
}

TEST_CASE("relief: the widest band fits a map, and no source is flat") {
    const Relief relief = make_relief(with(NoiseTexture{0.001, 0.064, 1}));
    CHECK(relief.map.n_u == 1024);
    CHECK(make_relief({}).map.heights == std::vector<float>{0.0F});
}
