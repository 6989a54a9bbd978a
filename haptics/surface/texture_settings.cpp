#include "haptics/surface/texture_settings.h"

#include "haptics/base/range.h"

#include <algorithm>
#include <string>

namespace fulcrum {
namespace {

constexpr double kMostSamples = 4096.0;  // of a side: what a texture of a graphics card may have
constexpr double kShortest_m = 1.0e-4;   // shorter waves are not felt by a stylus that is held
constexpr double kLongest_m = 1.0;
constexpr double kLargestTile_m = 100.0;
constexpr double kWidestBand =
    64.0;  // longest over shortest wave: a tile of the one in samples of the other

Expected<void> check_map(const HeightMap& map) {
    const Range ranges[] = {
        {"width in samples", static_cast<double>(map.n_u), 1.0, kMostSamples},
        {"height in samples", static_cast<double>(map.n_v), 1.0, kMostSamples},
    };
    if (Expected<void> good = check_ranges("the height map's", ranges); !good) {
        return good;
    }
    const std::size_t wanted =
        static_cast<std::size_t>(map.n_u) * static_cast<std::size_t>(map.n_v);
    if (map.heights.size() != wanted) {
        return fail("the height map has " + std::to_string(map.heights.size()) + " heights and " +
                        std::to_string(wanted) + " places",
                    {}, "give it one height a place");
    }
    const bool sane =
        std::ranges::all_of(map.heights, [](float h) { return h >= 0.0F && h <= 1.0F; });
    return sane ? Expected<void>{}
                : fail("a height of the height map is not 0 to 1", {}, "scale the heights");
}

Expected<void> check(const std::monostate& /*none*/) {
    return {};
}
Expected<void> check(const ImageTexture& image) {
    if (!image.map) {
        return fail("a texture has no height map", {}, "give it one");
    }
    const Range ranges[] = {
        {"tile width in metres", image.tile_u_m, kShortest_m, kLargestTile_m},
        {"tile height in metres", image.tile_v_m, kShortest_m, kLargestTile_m},
    };
    return check_ranges("the texture's", ranges).and_then([&] { return check_map(*image.map); });
}
Expected<void> check(const SineTexture& sine) {
    const Range ranges[] = {
        {"wavelength in metres", sine.wavelength_m, kShortest_m, kLongest_m},
        {"direction in radians", sine.direction_rad, -100.0, 100.0},
    };
    return check_ranges("the grooves'", ranges);
}
Expected<void> check(const NoiseTexture& noise) {
    const Range ranges[] = {
        {"longest wavelength in metres", noise.longest_m, kShortest_m, kLongest_m},
        {"shortest wavelength in metres", noise.shortest_m,
         std::max(kShortest_m, noise.longest_m / kWidestBand), noise.longest_m},
    };
    return check_ranges("the bumps'", ranges);
}

}  // namespace

Expected<void> validate(const TextureSettings& settings) {
    const Range ranges[] = {
        {"height in metres", settings.height_m, 1.0e-7, 0.01},
        {"gain", settings.gain, 0.0, 100.0},
    };
    return check_ranges("the texture's", ranges).and_then([&] {
        return std::visit([](const auto& source) { return check(source); }, settings.source);
    });
}

}  // namespace fulcrum
