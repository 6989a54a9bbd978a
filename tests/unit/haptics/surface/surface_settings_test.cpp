// What a surface may be set to: friction, texture, transient, shading, and the plan of them all.
#include "haptics/surface/friction.h"
#include "haptics/surface/surface_plan.h"
#include "haptics/surface/texture_settings.h"
#include "haptics/surface/transient_settings.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <memory>

using namespace fulcrum;

namespace {

// A number of some settings, with its range.
template <class Settings>
struct Bounds {
    double Settings::*field;
    double low, high;
};

// Accepted at its bounds, refused just past them and where it is no number.
template <class Settings>
void check_bounds(const Settings& good, std::initializer_list<Bounds<Settings>> all) {
    REQUIRE(validate(good));
    int n = 0;
    for (const Bounds<Settings>& bounds : all) {
        CAPTURE(n++);
        const auto accepts = [&](double value) {
            Settings settings = good;
            settings.*bounds.field = value;
            return validate(settings).has_value();
        };
        CHECK(accepts(bounds.low));
        CHECK(accepts(bounds.high));
        CHECK_FALSE(accepts(bounds.low - 1.0e-6));
        CHECK_FALSE(accepts(bounds.high * 1.001));
        CHECK_FALSE(accepts(kNan));
    }
}

TextureSettings with(const TextureSource& source) {
    TextureSettings settings;
    settings.source = source;
    return settings;
}
TextureSettings make_image(HeightMap map, double tile_m = 0.05) {
    return with(ImageTexture{std::make_shared<const HeightMap>(std::move(map)), tile_m, tile_m});
}
std::string refusal(const TextureSettings& settings) {
    const auto valid = validate(settings);
    return valid ? "" : to_sentence(valid.error());
}

}  // namespace

TEST_CASE("surface settings: each number is accepted at its bounds and refused past them") {
    check_bounds<TransientSettings>({}, {{&TransientSettings::force_Ns_per_m, 0.0, 100.0},
                                         {&TransientSettings::acceleration_per_s, 0.0, 1.0e4},
                                         {&TransientSettings::frequency_Hz, 5.0, 1000.0},
                                         {&TransientSettings::decay_per_s, 5.0, 2000.0},
                                         {&TransientSettings::pulse_s, 0.001, 0.1},
                                         {&TransientSettings::max_force_N, 0.1, 10.0},
                                         {&TransientSettings::energy_share, 0.0, 1.0}});
    check_bounds<ShadingSettings>({true, 10.0}, {{&ShadingSettings::crease_angle_deg, 0.0, 180.0}});
    check_bounds(with(SineTexture{}), {{&TextureSettings::height_m, 1.0e-7, 0.01},
                                       {&TextureSettings::gain, 0.0, 100.0}});
    check_bounds<FrictionSettings>({5.0, 0.4, 2.0},
                                   {{&FrictionSettings::static_coefficient, 0.4, 5.0},
                                    {&FrictionSettings::dynamic_coefficient, 0.0, 5.0},
                                    {&FrictionSettings::viscous_Ns_per_m, 0.0, 100.0}});
    CHECK_FALSE(validate(FrictionSettings{0.3, 0.4, 0.0}));
}

TEST_CASE("surface settings: there is an effect as soon as one of its parts is there") {
    CHECK_FALSE(FrictionSettings{}.any());
    CHECK(FrictionSettings{0.1, 0.0, 0.0}.any());
    CHECK(FrictionSettings{0.0, 0.0, 0.1}.any());
    TransientSettings transient;
    CHECK_FALSE(transient.any());
    transient.kind = TransientKind::fixed_pulse;
    CHECK(transient.any());
    // A texture with a source and a gain.
    TextureSettings texture;
    CHECK_FALSE(texture.any());
    CHECK(validate(texture));
    texture.source = SineTexture{};
    CHECK(texture.any());
    texture.gain = 0.0;
    CHECK_FALSE(texture.any());
}

TEST_CASE("surface settings: a plan that asks for nothing is good, and each part is checked") {
    CHECK(validate(SurfacePlan{}));
    SurfacePlan texture;
    texture.texture.gain = -1.0;
    CHECK_FALSE(validate(texture));
    SurfacePlan transient;
    transient.transient.pulse_s = 1.0;
    CHECK_FALSE(validate(transient));
    SurfacePlan shading;
    shading.shading.crease_angle_deg = 181.0;
    REQUIRE_FALSE(validate(shading));
    CHECK(to_sentence(validate(shading).error()).find("0 to 180") != std::string::npos);
}

TEST_CASE("surface settings: an image has one height from 0 to 1 at each place") {
    CHECK(refusal(make_image({2, 2, {0.0F, 0.5F, 1.0F, 0.0F}})).empty());
    CHECK(refusal(make_image({1, 1, {0.5F}})).empty());
    CHECK(refusal(make_image({2, 2, {0.0F, 0.5F, 1.0F}})).find("3 heights and 4 places") !=
          std::string::npos);
    CHECK(refusal(make_image({2, 1, {0.0F, 1.01F}})).find("not 0 to 1") != std::string::npos);
    CHECK(refusal(with(ImageTexture{})).find("no height map") != std::string::npos);
    for (const TextureSettings& bad :
         {make_image({2, 1, {0.0F, -0.01F}}), make_image({2, 1, {0.0F, std::nanf("")}}),
          make_image({0, 1, {}}), make_image({4097, 1, std::vector<float>(4097)}),
          make_image({1, 1, {0.5F}}, 0.0), make_image({1, 1, {0.5F}}, 101.0)}) {
        CHECK_FALSE(refusal(bad).empty());
    }
}

TEST_CASE("surface settings: grooves and bumps are held to their ranges") {
    for (const TextureSource& good : std::initializer_list<TextureSource>{
             SineTexture{1.0e-4, -100.0}, SineTexture{1.0, 100.0}, NoiseTexture{0.001, 0.001, 3},
             NoiseTexture{0.001, 0.064, 3}}) {
        CHECK(refusal(with(good)).empty());
    }
    for (const TextureSource& bad : std::initializer_list<TextureSource>{
             SineTexture{0.9e-4, 0.0}, SineTexture{1.1, 0.0}, SineTexture{0.01, kNan},
             SineTexture{kNan, 0.0}, NoiseTexture{0.001, 0.065, 3},  // too wide a band
             NoiseTexture{0.002, 0.001, 3},                          // the longest is the shorter
             NoiseTexture{0.9e-4, 0.001, 3}, NoiseTexture{0.5, 1.1, 3},
             NoiseTexture{kNan, 0.001, 3}, NoiseTexture{0.001, kNan, 3}}) {
        CHECK_FALSE(refusal(with(bad)).empty());
    }
}
