#include "haptics/surface/texture.h"

#include "haptics/math/spatial.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <rapidcheck.h>

using namespace fulcrum;

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

TextureSettings make_grooves(TextureLaw law, double direction_rad = 0.0) {
    TextureSettings settings;
    settings.source = SineTexture{0.002, direction_rad};
    settings.law = law;
    settings.height_m = 2.0e-4;
    return settings;
}

}  // namespace

TEST_CASE("texture: the thesis' law, d deep and shallow, in its own words") {
    TextureSettings settings = make_grooves(TextureLaw::perturbed_normal);
    settings.gain = 2.0;
    const HeightSample relief{1.0e-4, 0.3, -0.2};
    // N = (0, 0, 1), grad h = (0.3, -0.2, 0): M = (-0.3, 0.2, 1).
    for (const double d : {5.0e-4, 2.0e-4, 1.0e-4, 0.0}) {
        const double kh = 2.0 * 1.0e-4;
        const Vector3 normal = Vector3::UnitZ();
        const Vector3 slope(0.3, -0.2, 0.0);
        const Vector3 m = normal - slope + slope.dot(normal) * normal;
        const Vector3 force = d >= kh ? Vector3((d - kh) * normal + kh * m) : Vector3(d * m);
        const TextureOffset felt = compute_texture_offset(settings, relief, d);
        CHECK(felt.along.u_m == Approx(force.x()).margin(1e-18));
        CHECK(felt.along.v_m == Approx(force.y()).margin(1e-18));
        CHECK(felt.normal_m == Approx(force.z() - d).margin(1e-18));
        CHECK(felt.height_m == 1.0e-4);
    }
}

TEST_CASE(
    "texture: Minsky's force goes against the slope; a carved one only as far as it reaches") {
    TextureSettings settings = make_grooves(TextureLaw::lateral);
    settings.gain = 1.5;
    const HeightSample relief{1.0e-4, 0.3, -0.2};
    for (const double d : {0.0, 1.0e-3, 4.0e-3}) {
        const TextureOffset felt = compute_texture_offset(settings, relief, d);
        CHECK(felt.normal_m == 0.0);
        CHECK(felt.along.u_m == Approx(-1.5 * d * 0.3).margin(1e-18));
        CHECK(felt.along.v_m == Approx(1.5 * d * 0.2).margin(1e-18));
    }
    settings = make_grooves(TextureLaw::height_offset);
    const HeightSample valley{0.0, 0.1, 0.0};
    const HeightSample peak{2.0e-4, 0.0, 0.0};
    CHECK(compute_texture_offset(settings, peak, 1.0e-3).normal_m == 0.0);
    CHECK(compute_texture_offset(settings, valley, 1.0e-3).normal_m == Approx(-2.0e-4));
    CHECK(compute_texture_offset(settings, valley, 1.0e-3).along.u_m == Approx(-8.0e-5));
    // Above the valley's floor nothing is touched.
    CHECK(compute_texture_offset(settings, valley, 1.0e-4).normal_m == Approx(-1.0e-4));
    CHECK(compute_texture_offset(settings, valley, 1.0e-4).along.u_m == 0.0);
}

// A board of black and white squares, 4 mm wide: nothing has sharper edges.
TextureSettings make_board(TextureLaw law) {
    HeightMap map{.n_u = 32, .n_v = 32, .heights = {}};
    for (int v = 0; v < 32; ++v) {
        for (int u = 0; u < 32; ++u) {
            map.heights.push_back((u / 4 + v / 4) % 2 == 0 ? 0.0F : 1.0F);
        }
    }
    TextureSettings settings;
    settings.source = ImageTexture{std::make_shared<const HeightMap>(map), 0.032, 0.032};
    settings.law = law;
    settings.height_m = 2.0e-4;
    return settings;
}

TEST_CASE("texture: an image's sharp edges do not make the relief higher than it is said to be") {
    const TextureSettings settings = make_board(TextureLaw::lateral);
    const Texture texture(settings);
    double low_m = 1.0;
    double high_m = -1.0;
    for (int i = 0; i < 320; ++i) {
        for (int j = 0; j < 320; ++j) {
            const double here_m = texture.relief({1.0e-4 * i, 1.0e-4 * j}).height_m;
            low_m = std::min(low_m, here_m);
            high_m = std::max(high_m, here_m);
        }
    }
    CHECK(std::abs(low_m) <= 0.015 * settings.height_m);
    CHECK(std::abs(high_m - settings.height_m) <= 0.015 * settings.height_m);
    // What has no sharp edges is as it was: grooves to the last sample.
    CHECK(Texture(make_grooves(TextureLaw::lateral)).relief({0.0005, 0.0}).height_m ==
          Approx(2.0e-4).epsilon(1e-7));
}

// The energy that a law gives on a way round a rectangle of place and depth, over the energy that goes round.
double work_round(const TextureSettings& settings, double shallow_m, double deep_m,
                  const SurfaceVector& from = {}) {
    const Texture texture(settings);
    const int n = 4000;
    double given = 0.0;
    double moved = 0.0;
    const auto force = [&](double s, double d) {
        const TextureOffset felt = texture.feel({from.u_m + s, from.v_m}, {}, d);
        return std::pair{felt.along.u_m, felt.normal_m};
    };
    for (int i = 0; i < n; ++i) {
        const double s = 0.0007 * (i + 0.5) / n;  // from the mean height past a peak
        const double d = shallow_m + (deep_m - shallow_m) * (i + 0.5) / n;
        const double ds = 0.0007 / n;
        const double dd = (deep_m - shallow_m) / n;
        const double steps[] = {force(s, deep_m).first * ds, -force(s, shallow_m).first * ds,
                                // The hand goes deeper against the normal.
                                -force(0.0, d).second * dd, force(0.0007, d).second * dd};
        for (const double step : steps) {
            given += step;
            moved += std::abs(step);
        }
    }
    return given / moved;
}

TEST_CASE("texture: the carved surface is a potential's gradient, and the thesis' law deep in it") {
    constexpr double kDiscretised = 1.0e-4;
    const TextureSettings carved = make_grooves(TextureLaw::height_offset);
    CHECK(std::abs(work_round(carved, 0.5e-4, 1.0e-3)) < kDiscretised);
    const TextureSettings thesis = make_grooves(TextureLaw::perturbed_normal);
    CHECK(std::abs(work_round(thesis, 2.1e-4, 1.0e-3)) < kDiscretised);
    // Over the edge of a square too, where a curve through the samples would swing beyond them.
    const TextureSettings board = make_board(TextureLaw::height_offset);
    CHECK(std::abs(work_round(board, 0.5e-4, 1.0e-3, {0.0044, 0.0016})) < kDiscretised);
    // And these are not: what energy_loan.h is there for.
    CHECK(std::abs(work_round(thesis, 0.2e-4, 1.0e-3)) > 0.1);
    CHECK(std::abs(work_round(make_grooves(TextureLaw::lateral), 0.2e-4, 1.0e-3)) > 0.1);
}

TEST_CASE("texture: grooves run across their direction") {
    const double direction = 0.6;
    const Texture texture(make_grooves(TextureLaw::lateral, direction));
    const double c = std::cos(direction);
    const double s = std::sin(direction);
    for (int i = 0; i < 50; ++i) {
        const double u = 1.3e-4 * i;
        const double v = -0.7e-4 * i;
        const double phase = kTwoPi * (c * u + s * v) / 0.002;
        const double slope = 1.0e-4 * kTwoPi / 0.002 * std::cos(phase);
        const HeightSample relief = texture.relief({u, v});
        CHECK(relief.height_m == Approx(1.0e-4 * (1.0 + std::sin(phase))).margin(1.0e-8));
        CHECK(relief.slope_u == Approx(c * slope).margin(1.0e-4));
        CHECK(relief.slope_v == Approx(s * slope).margin(1.0e-4));
        const TextureOffset felt = texture.feel({u, v}, {}, 0.001);
        CHECK(felt.along.u_m == Approx(-0.001 * c * slope).margin(1.0e-7));
        CHECK(felt.along.v_m == Approx(-0.001 * s * slope).margin(1.0e-7));
    }
    // Along the grooves nothing changes, however fast.
    const TextureOffset still = texture.feel({0.0003, 0.0}, {}, 0.001);
    const TextureOffset fast = texture.feel({0.0003, 0.0}, {-0.01 * s, 0.01 * c}, 0.001);
    CHECK(fast.along.u_m == Approx(still.along.u_m).epsilon(1.0e-6));
}

TEST_CASE("texture: a hand at rest feels the relief itself, and the filter comes without a step") {
    const Texture texture(make_grooves(TextureLaw::perturbed_normal));
    TextureOffset before = texture.feel({0.0003, 0.0}, {}, 0.001);
    CHECK(
        before.along.u_m ==
        compute_texture_offset(texture.settings(), texture.relief({0.0003, 0.0}), 0.001).along.u_m);
    // Of the largest force; where the filter, a sample more a round or another level comes in.
    const double largest = 2.0e-4 * 1.0e-4 * kTwoPi / 0.002;
    for (double stroke = 0.0; stroke < 0.01; stroke += 2.0e-6) {
        const TextureOffset felt = texture.feel({0.0003, 0.0}, {stroke, 0.0}, 0.001);
        CHECK(std::abs(felt.along.u_m - before.along.u_m) < 0.03 * largest);
        before = felt;
    }
}

TEST_CASE("texture: never a pull, never more than the relief's height, nothing from nowhere") {
    CHECK(rc::check("of any law, place and stroke", [] {
        TextureSettings settings;
        settings.source = NoiseTexture{0.001, 0.002, 1};
        settings.law = static_cast<TextureLaw>(*rc::gen::inRange(0, 3));
        settings.height_m = 5.0e-4;
        settings.gain = 0.1 * *rc::gen::inRange(0, 1000);
        static const Texture bumps(settings);
        const Texture texture =
            settings.law == TextureLaw::perturbed_normal ? bumps : Texture(settings);
        const auto any = [] { return 1.0e-5 * *rc::gen::inRange(-10000, 10000); };
        const double depth = 1.0e-5 * *rc::gen::inRange(0, 1000);
        const TextureOffset felt = texture.feel({any(), any()}, {any(), any()}, depth);
        RC_ASSERT(felt.normal_m <= 0.0);
        RC_ASSERT(felt.normal_m >= -depth);
        RC_ASSERT(felt.height_m > -0.05 * settings.height_m);
        RC_ASSERT(felt.height_m < 1.05 * settings.height_m);
        RC_ASSERT(std::isfinite(felt.along.u_m) && std::isfinite(felt.along.v_m));
    }));
    const Texture texture(make_grooves(TextureLaw::height_offset));
    const double nan = std::nan("");
    for (const TextureOffset& felt :
         {texture.feel({nan, 0.0}, {}, 0.0), texture.feel({}, {nan, 0.0}, 0.001),
          texture.feel({}, {0.0, HUGE_VAL}, 0.001), texture.feel({}, {}, nan),
          texture.feel({}, {}, -0.001)}) {
        CHECK(felt.along.u_m == 0.0);
        CHECK(felt.normal_m == 0.0);
    }
}

TEST_CASE("texture: what fingers would measure of grooves, and no source is kept beside") {
    TextureSettings settings = make_grooves(TextureLaw::lateral);
    const TextureFacts facts = measure_texture(settings, 500.0, 1.0);
    CHECK(facts.rms_height_m == Approx(1.0e-4 / std::sqrt(2.0)).epsilon(1.0e-3));
    CHECK(facts.rms_lateral_share ==
          Approx(1.0e-4 * kTwoPi / 0.002 / std::sqrt(2.0)).epsilon(1.0e-3));
    settings.source = {};
    CHECK(measure_texture(settings, 500.0, 1.0).rms_lateral_share == 0.0);
    CHECK(measure_texture(make_grooves(TextureLaw::lateral), 0.0, 1.0).rms_height_m == 0.0);
    const Texture texture(make_grooves(TextureLaw::lateral));
    CHECK_FALSE(texture.settings().any());
    CHECK(texture.memory_bytes() >= sizeof(Texture) + 63 * sizeof(float));
    CHECK(texture.memory_bytes() < 4096);
}
