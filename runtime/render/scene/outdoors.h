// What makes a meadow of the open air: clouds that stand still and two ranges of hills behind the haze, and tufts of grass
// and flowers around the round cloth.
//
//   ridge(a) = mean + sum of A_k sin(k a + phase_k), degrees above the horizon at the azimuth a: k whole, so that it closes
//   tuft i   at the radius r_0 (r_1/r_0)^((i + 1/2)/n) and the azimuth g i, g the golden angle: as dense in the picture near
//            and far
//
// Thread: any; values. Cost: of the sky one projection a cloud and two each kRidgeStep_deg; the meadow is made once.
#pragma once

#include "runtime/render/camera.h"
#include "runtime/render/scene/space.h"

#include <cstddef>
#include <vector>

namespace fulcrum::runtime {

/// Of a corner of the sky: place in the picture (-1 to 1, +y up), colour as it is stored, and its alpha.
inline constexpr std::size_t kFloatsPerSkyCorner = 6;
/// Of a corner of the meadow: x, height, z from the middle of the cloth, in reaches of the light, and colour as it is stored.
inline constexpr std::size_t kFloatsPerMeadowCorner = 6;

inline constexpr int kClouds = 16;  ///< all around
inline constexpr int kTufts = 240;
inline constexpr double kRidgeStep_deg = 1.5;
inline constexpr double kMeadowReach = 2.6;  ///< the furthest tuft, in reaches of the light
/// A blade's or flower's height at most, in reaches.
inline constexpr double kTallestTuft = 0.06;

/// Clouds, then hills before them: triangles, the later over the earlier.
[[nodiscard]] std::vector<float> sky_corners(const Camera& camera, const PictureSize& size);

/// A tuft of grass or a flower: where it stands, and its corners.
struct Plant {
    Vector3f foot{Vector3f::Zero()};  ///< from the middle of the cloth, in reaches
    int first = 0;
    int count = 0;
};
struct Meadow {
    std::vector<float> corners;  ///< of triangles
    std::vector<Plant> plants;   ///< those far from a camera that looks along -Z first
};
/// Nothing stands nearer to the middle than `from` reaches.
[[nodiscard]] Meadow make_meadow(double from);

}  // namespace fulcrum::runtime
