// Where a texture's heights come from, whatever its source: every kind becomes a grid of one period.
//
//   grooves   32 samples of a wave; the grid is laid across the grooves, so one row is enough
//   bumps     a square tile of 4 of the longest waves; kWaves waves, their lengths even in the logarithm over the band, their
//             directions even, each rounded to the nearest wave that fits a whole number of times into the tile both ways
//             (a band's edge moves by an eighth of the longest wave at most), phases by the seed, all of one amplitude;
//             then stretched to 0 ... 1. Four samples at least of the shortest wave.
//
// Thread: load. Cost: bumps up to half a second where the band is widest.
#pragma once

#include "haptics/surface/texture_settings.h"

namespace fulcrum {

inline constexpr int kBumpWaves = 128;

/// One period of a texture, and how it lies on the surface.
struct Relief {
    HeightMap map;
    double tile_u_m = 1.0;
    double tile_v_m = 1.0;
    double turn_rad = 0.0;  ///< from the surface's u axis to the grid's
};

/// Takes settings that `validate` accepted; without a source a relief of height 0.
[[nodiscard]] Relief make_relief(const TextureSettings& settings);

}  // namespace fulcrum
