#include "haptics/surface/texture_settings.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TextureSettings make_image(HeightMap map, double tile_m = 0.05) {
    TextureSettings settings;
    settings.source =
        ImageTexture{std::make_shared<const HeightMap>(std::move(map)), tile_m, tile_m};
    return settings;
}

std::string refusal(const TextureSettings& settings) {
    const auto valid = validate(settings);
    return valid ? "" : to_sentence(valid.error());
}

}  // namespace

TEST_CASE("texture settings: nothing is a texture only with a source and a gain") {
    TextureSettings settings;
    CHECK_FALSE(settings.any());
    CHECK(validate(settings));
    settings.source = SineTexture{};
    CHECK(settings.any());
    settings.gain = 0.0;
    CHECK_FALSE(settings.any());
}

TEST_CASE("texture settings: height and gain are held to their ranges") {
    const auto accepts = [](double TextureSettings::*field, double value) {
        TextureSettings settings;
        settings.source = SineTexture{};
        settings.*field = value;
        return validate(settings).has_value();
    };
    CHECK(accepts(&TextureSettings::height_m, 1.0e-7));
    CHECK(accepts(&TextureSettings::height_m, 0.01));
    CHECK_FALSE(accepts(&TextureSettings::height_m, 0.0));
    CHECK_FALSE(accepts(&TextureSettings::height_m, 0.0101));
    CHECK_FALSE(accepts(&TextureSettings::height_m, kNan));
    CHECK(accepts(&TextureSettings::gain, 0.0));
    CHECK(accepts(&TextureSettings::gain, 100.0));
    CHECK_FALSE(accepts(&TextureSettings::gain, -0.1));
    CHECK_FALSE(accepts(&TextureSettings::gain, kNan));
}

TEST_CASE("texture settings: an image has one height from 0 to 1 at each place") {
    CHECK(refusal(make_image({2, 2, {0.0F, 0.5F, 1.0F, 0.0F}})).empty());
    CHECK(refusal(make_image({1, 1, {0.5F}})).empty());
    CHECK(refusal(make_image({2, 2, {0.0F, 0.5F, 1.0F}})).find("3 heights and 4 places") !=
          std::string::npos);
    CHECK(refusal(make_image({2, 1, {0.0F, 1.01F}})).find("not 0 to 1") != std::string::npos);
    CHECK_FALSE(refusal(make_image({2, 1, {0.0F, -0.01F}})).empty());
    CHECK_FALSE(refusal(make_image({2, 1, {0.0F, std::nanf("")}})).empty());
    CHECK_FALSE(refusal(make_image({0, 1, {}})).empty());
    CHECK_FALSE(refusal(make_image({4097, 1, std::vector<float>(4097)})).empty());
    CHECK_FALSE(refusal(make_image({1, 1, {0.5F}}, 0.0)).empty());
    CHECK_FALSE(refusal(make_image({1, 1, {0.5F}}, 101.0)).empty());
    TextureSettings nothing;
    nothing.source = ImageTexture{};
    CHECK(refusal(nothing).find("no height map") != std::string::npos);
}

TEST_CASE("texture settings: grooves and bumps are held to their ranges") {
    const auto accepts = [](const TextureSource& source) {
        TextureSettings settings;
        settings.source = source;
        return validate(settings).has_value();
    };
    CHECK(accepts(SineTexture{1.0e-4, -100.0}));
    CHECK(accepts(SineTexture{1.0, 100.0}));
    CHECK_FALSE(accepts(SineTexture{0.9e-4, 0.0}));
    CHECK_FALSE(accepts(SineTexture{1.1, 0.0}));
    CHECK_FALSE(accepts(SineTexture{0.01, kNan}));
    CHECK_FALSE(accepts(SineTexture{kNan, 0.0}));
    CHECK(accepts(NoiseTexture{0.001, 0.001, 3}));
    CHECK(accepts(NoiseTexture{0.001, 0.064, 3}));
    CHECK_FALSE(accepts(NoiseTexture{0.001, 0.065, 3}));  // too wide a band
    CHECK_FALSE(accepts(NoiseTexture{0.002, 0.001, 3}));  // the longest is the shorter
    CHECK_FALSE(accepts(NoiseTexture{0.9e-4, 0.001, 3}));
    CHECK_FALSE(accepts(NoiseTexture{0.5, 1.1, 3}));
    CHECK_FALSE(accepts(NoiseTexture{kNan, 0.001, 3}));
    CHECK_FALSE(accepts(NoiseTexture{0.001, kNan, 3}));
}
