#include "haptics/surface/relief.h"
#include "haptics/surface/texture_map.h"
#include "haptics/surface/triplanar.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <rapidcheck.h>

using namespace fulcrum;

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

Texture make_bumps(TextureLaw law) {
    TextureSettings settings;
    settings.source = NoiseTexture{0.002, 0.004, 2};
    settings.law = law;
    settings.height_m = 3.0e-4;
    return Texture(settings);
}

Vector3 any_unit() {
    for (;;) {
        const auto any = [] { return 0.01 * *rc::gen::inRange(-100, 101); };
        const Vector3 v(any(), any(), any());
        if (v.norm() > 0.1) {
            return v.normalized();
        }
    }
}

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

HeightMap make_random(std::int32_t n_u, std::int32_t n_v, unsigned seed) {
    std::mt19937 random(seed);
    HeightMap map{n_u, n_v, {}};
    for (std::int32_t i = 0; i < n_u * n_v; ++i) {
        map.heights.push_back(static_cast<float>(random() % 1001) / 1000.0F);
    }
    return map;
}

// `waves` waves of a sine along u on n x 1 samples.
HeightMap make_wave(std::int32_t n, int waves) {
    HeightMap map{n, 1, {}};
    for (std::int32_t i = 0; i < n; ++i) {
        map.heights.push_back(static_cast<float>(0.5 + 0.5 * std::sin(kTwoPi * waves * i / n)));
    }
    return map;
}

}  // namespace

TEST_CASE("triplanar: a face along an axis has one view; weights add up to one, without a step") {
    const Vector3 p(0.01, 0.02, 0.03);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const Vector3 normal = sign * Vector3::Unit(static_cast<Index>(axis));
            const Vector3 weights = compute_view_weights(normal);
            CHECK(weights == Vector3::Unit(static_cast<Index>(axis)));
        }
    }
    CHECK(project_on_view(0, p).u_m == 0.03);
    CHECK(project_on_view(0, p).v_m == 0.02);
    CHECK(project_on_view(1, p).u_m == 0.01);
    CHECK(project_on_view(1, p).v_m == 0.03);
    CHECK(project_on_view(2, p).u_m == 0.01);
    CHECK(project_on_view(2, p).v_m == 0.02);
    CHECK(rc::check("for any normal", [] {
        const Vector3 normal = any_unit();
        const Vector3 weights = compute_view_weights(normal);
        RC_ASSERT(std::abs(weights.sum() - 1.0) < 1.0e-12);
        RC_ASSERT(weights.minCoeff() >= 0.0);
        const Vector3 beside = (normal + 1.0e-6 * any_unit()).normalized();
        RC_ASSERT((compute_view_weights(beside) - weights).cwiseAbs().maxCoeff() < 1.0e-4);
    }));
}

TEST_CASE("triplanar: a slope lies along the surface; on a floor it is the texture itself") {
    static const Texture lateral = make_bumps(TextureLaw::lateral);
    static const Texture carved = make_bumps(TextureLaw::height_offset);
    CHECK(rc::check("for any normal", [] {
        const Vector3 normal = any_unit();
        const Vector3 place = 0.01 * any_unit();
        const BodyOffset felt = feel_on_body(lateral, place, 1.0e-4 * any_unit(), normal, 0.002);
        RC_ASSERT(std::abs(felt.offset_B_m.dot(normal)) < 1.0e-15);
        const BodyOffset cut = feel_on_body(carved, place, Vector3::Zero(), normal, 0.002);
        RC_ASSERT(cut.offset_B_m.dot(normal) <= 1.0e-15);
        // Between its samples a relief may reach a little over its peak.
        RC_ASSERT(std::abs(-cut.offset_B_m.dot(normal) - (3.0e-4 - cut.height_m)) < 3.0e-6);
    }));
    const Texture texture = make_bumps(TextureLaw::perturbed_normal);
    const Vector3 place(0.0013, 0.5, -0.0021);
    const Vector3 stroke(3.0e-4, 0.0, 1.0e-4);
    const BodyOffset felt = feel_on_body(texture, place, stroke, Vector3::UnitY(), 0.001);
    const TextureOffset flat = texture.feel({0.0013, -0.0021}, {3.0e-4, 1.0e-4}, 0.001);
    CHECK(felt.offset_B_m.x() == flat.along.u_m);
    CHECK(felt.offset_B_m.z() == flat.along.v_m);
    CHECK(felt.offset_B_m.y() == Approx(flat.normal_m).margin(1.0e-18));
    CHECK(felt.place.u_m == 0.0013);
    CHECK(felt.place.v_m == -0.0021);
    CHECK(felt.height_m == flat.height_m);
}

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

TEST_CASE("relief: the seed says which bumps; the widest band fits, and no source is flat") {
    const auto heights = [](std::uint32_t seed) {
        return make_relief(with(NoiseTexture{0.001, 0.002, seed})).map.heights;
    };
    CHECK(heights(3) == heights(3));
    CHECK(heights(3) != heights(4));
    const Relief relief = make_relief(with(NoiseTexture{0.001, 0.064, 1}));
    CHECK(relief.map.n_u == 1024);
    CHECK(make_relief({}).map.heights == std::vector<float>{0.0F});
}

TEST_CASE("texture map: the finest level goes through every sample") {
    for (const auto& [n_u, n_v] : {std::pair{1, 1}, {2, 1}, {3, 2}, {7, 5}, {16, 16}, {40, 9}}) {
        const HeightMap map = make_random(n_u, n_v, 7);
        const TextureMap texture(map, 0.3, 0.2, 0.002);
        for (int j = 0; j < n_v; ++j) {
            for (int i = 0; i < n_u; ++i) {
                const auto k = static_cast<std::size_t>(j * n_u + i);
                const HeightSample sample = texture.sample(0, 0.3 * i / n_u, 0.2 * j / n_v);
                // Coefficients are kept in single precision.
                CHECK(sample.height_m ==
                      Approx(0.002 * static_cast<double>(map.heights[k])).margin(1.0e-9));
            }
        }
    }
}

TEST_CASE("texture map: the slope is the height's derivative, and the height repeats") {
    CHECK(rc::check("anywhere on any map", [] {
        const auto map = make_random(*rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20),
                                     *rc::gen::inRange(0U, 1000U));
        const TextureMap texture(map, 0.05, 0.08, 0.001);
        const auto level = *rc::gen::inRange<std::size_t>(0, texture.n_levels());
        const double u = 1.0e-4 * *rc::gen::inRange(-2000, 2000);
        const double v = 1.0e-4 * *rc::gen::inRange(-2000, 2000);
        const double e = 1.0e-7;
        const HeightSample at = texture.sample(level, u, v);
        const double along_u =
            (texture.sample(level, u + e, v).height_m - texture.sample(level, u - e, v).height_m) /
            (2.0 * e);
        const double along_v =
            (texture.sample(level, u, v + e).height_m - texture.sample(level, u, v - e).height_m) /
            (2.0 * e);
        RC_ASSERT(std::abs(at.slope_u - along_u) < 1.0e-5);
        RC_ASSERT(std::abs(at.slope_v - along_v) < 1.0e-5);
        const HeightSample next = texture.sample(level, u + 0.05, v - 3 * 0.08);
        RC_ASSERT(std::abs(next.height_m - at.height_m) < 1.0e-12);
    }));
}

TEST_CASE("texture map: a sine of eight samples a wave is itself, slope and all, to 1.2 permille") {
    const double tile_m = 0.016;
    const TextureMap texture(make_wave(64, 8), tile_m, 1.0, 2.0);
    for (int i = 0; i < 500; ++i) {
        const double u = tile_m * i / 500.0;
        const double phase = kTwoPi * 8.0 * u / tile_m;
        const HeightSample sample = texture.sample(0, u, 0.3);
        CHECK(sample.height_m - 1.0 == Approx(std::sin(phase)).margin(1.2e-3));
        CHECK(
            sample.slope_u ==
            Approx(kTwoPi * 8.0 / tile_m * std::cos(phase)).margin(5.0e-3 * kTwoPi * 8.0 / tile_m));
        CHECK(sample.slope_v == Approx(0.0).margin(1.0e-9));
    }
}

TEST_CASE("texture map: a coarser level keeps long waves and their mean, and drops short ones") {
    const auto swing = [](const TextureMap& map, std::size_t level) {
        double low = HUGE_VAL;
        double high = -HUGE_VAL;
        double sum = 0.0;
        for (int i = 0; i < 1000; ++i) {
            const double height = map.sample(level, 1.0e-3 * i, 0.0).height_m;
            low = std::min(low, height);
            high = std::max(high, height);
            sum += height;
        }
        CHECK(sum / 1000.0 == Approx(0.5).margin(0.01));
        return high - low;
    };
    const TextureMap lengthy(make_wave(64, 4), 1.0, 1.0, 1.0);
    REQUIRE(lengthy.n_levels() == 7);
    CHECK(swing(lengthy, 2) == Approx(1.0).margin(0.03));  // 4 samples a wave
    const TextureMap brief(make_wave(64, 14), 1.0, 1.0, 1.0);
    CHECK(swing(brief, 1) > 0.7);   // 2.3 samples a wave
    CHECK(swing(brief, 2) < 0.02);  // 1.1 samples a wave: it would be folded
    CHECK(swing(brief, 6) < 1.0e-6);
}

TEST_CASE("texture map: levels halve down to one sample, whatever the sides") {
    const TextureMap map(make_random(13, 3, 1), 1.0, 1.0, 1.0);
    REQUIRE(map.n_levels() == 5);
    CHECK(map.n_u(1) == 7);
    CHECK(map.n_v(1) == 2);
    CHECK(map.n_u(4) == 1);
    CHECK(map.n_v(4) == 1);
    CHECK(map.count_samples(0, 0.3, 0.0) == Approx(3.9));
    CHECK(map.count_samples(0, 0.0, -0.5) == Approx(1.5));
    CHECK(map.memory_bytes() >= sizeof(float) * (39 + 14 + 4 + 2 + 1));
}

TEST_CASE("texture map: its extremes are those at the samples and half-way, whatever the sides") {
    for (const auto& [n_u, n_v] : {std::pair(1, 1), {2, 1}, {1, 3}, {5, 2}, {3, 7}, {16, 9}}) {
        HeightMap random{.n_u = n_u, .n_v = n_v, .heights = {}};
        for (int i = 0; i < n_u * n_v; ++i) {
            random.heights.push_back(static_cast<float>((i * 7919 + 13) % 101) / 100.0F);
        }
        TextureMap map(random, 0.03, 0.02, 1.0e-3);
        const auto check = [&map](double factor, double offset_m, const TextureMap& before) {
            double low_m = 1.0;
            double high_m = -1.0;
            for (int j = 0; j < 2 * map.n_v(0); ++j) {
                for (int i = 0; i < 2 * map.n_u(0); ++i) {
                    const double u_m = 0.03 * 0.5 * i / map.n_u(0);
                    const double v_m = 0.02 * 0.5 * j / map.n_v(0);
                    const double here_m = map.sample(0, u_m, v_m).height_m;
                    REQUIRE(std::abs(here_m - (factor * before.sample(0, u_m, v_m).height_m +
                                               offset_m)) <= 1.0e-9);
                    low_m = std::min(low_m, here_m);
                    high_m = std::max(high_m, here_m);
                }
            }
            CHECK(std::abs(map.find_extremes().low_m - low_m) <= 1.0e-9);
            CHECK(std::abs(map.find_extremes().high_m - high_m) <= 1.0e-9);
        };
        const TextureMap before = map;
        check(1.0, 0.0, before);
        map.rescale(0.7, 2.0e-4);
        check(0.7, 2.0e-4, before);
        const std::size_t last = map.n_levels() - 1;
        CHECK(std::abs(map.sample(last, 0.0, 0.0).height_m -
                       (0.7 * before.sample(last, 0.0, 0.0).height_m + 2.0e-4)) <= 1.0e-9);
    }
}

TEST_CASE("texture map: places that are nowhere are flat") {
    const TextureMap map(make_random(8, 8, 1), 0.1, 0.1, 1.0);
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        CHECK(map.sample(0, bad, 0.0).height_m == 0.0);
        CHECK(map.sample(0, 0.0, bad).slope_v == 0.0);
    }
    CHECK(std::isfinite(map.sample(0, 1.0e300, -1.0e300).height_m));
}

TEST_CASE("texture map: resampling keeps a constant and, where it is coarser, the mean") {
    for (const double one : resample_periodic({3.0, 3.0, 3.0}, 5)) {
        CHECK(one == Approx(3.0).epsilon(1.0e-14));
    }
    const std::vector<double> halved = resample_periodic({0, 1, 0, 1, 0, 1, 0, 1}, 4);
    for (const double one : halved) {
        CHECK(one == Approx(0.5).margin(0.02));  // the wave is gone
    }
}

TEST_CASE("texture map: coefficients solve the spline's equations on the circle") {
    for (const std::size_t n : {1U, 2U, 3U, 4U, 11U, 64U}) {
        std::vector<double> samples;
        for (std::size_t i = 0; i < n; ++i) {
            samples.push_back(std::sin(3.7 * static_cast<double>(i)) + 0.3);
        }
        const std::vector<double> c = compute_spline_coefficients(samples);
        for (std::size_t i = 0; i < n; ++i) {
            const double value = (c[(i + n - 1) % n] + 4.0 * c[i] + c[(i + 1) % n]) / 6.0;
            CHECK(value == Approx(samples[i]).epsilon(1.0e-12));
        }
    }
}
