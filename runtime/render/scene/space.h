// The sky of a scene in space as coloured triangles: a dark background, stars that stand still far away, and orbits as lines
// of even width.
//
//   star i   direction d_i = (r cos g i, y, r sin g i), y = 1 - 2 (i + 1/2)/n, g the golden angle, moved a little by a
//            hash of i, so that the sky is even without a pattern and the same in every run
//
// Thread: any; values. Cost: one projection a star and kOrbitCorners an orbit.
#pragma once

#include "runtime/render/camera.h"

#include <cstddef>
#include <vector>

namespace fulcrum::runtime {

/// A circle that something goes along, seen as a thin line: centre + cos u * x + sin u * z.
struct Orbit {
    Vector3 centre_W{Vector3::Zero()};
    Vector3 x_W{Vector3::UnitX()};
    Vector3 z_W{Vector3::UnitZ()};
};

/// How large the picture is.
struct PictureSize {
    int width_px = 1;
    int height_px = 1;
    float scale = 1.0F;  ///< 1 in a picture of 720 lines
};

inline constexpr int kStars = 2500;
inline constexpr int kOrbitCorners = 160;
/// Of a corner: place in the picture (-1 to 1, +y up), colour as it is stored.
inline constexpr std::size_t kFloatsPerWallCorner = 5;

/// Triangles, five floats a corner, the later over the earlier.
[[nodiscard]] std::vector<float> space_corners(const Camera& camera,
                                               const std::vector<Orbit>& orbits,
                                               const PictureSize& size);

}  // namespace fulcrum::runtime
