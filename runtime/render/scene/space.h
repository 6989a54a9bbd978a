// The sky of a scene in space as coloured triangles: a dark background, stars that stand still far away, and orbits as lines
// of even width.
//
//   star i   direction d_i = (r cos g i, y, r sin g i), y = 1 - 2 (i + 1/2)/n, g the golden angle, moved a little by a
//            hash of i, so that the sky is even without a pattern and the same in every run
//
// Thread: any; values. Cost: one projection a star and kOrbitCorners an orbit.
#pragma once

#include "runtime/render/camera.h"
#include "runtime/render/scene/room.h"

#include <vector>

namespace fulcrum::runtime {

inline constexpr int kStars = 2500;
inline constexpr int kOrbitCorners = 160;
/// Of a corner: place in the picture (-1 to 1, +y up), colour as it is stored.
inline constexpr std::size_t kFloatsPerWallCorner = 5;

/// Triangles, five floats a corner, the later over the earlier.
[[nodiscard]] std::vector<float> space_corners(const Camera& camera,
                                               const std::vector<Orbit>& orbits,
                                               const PictureSize& size);

}  // namespace fulcrum::runtime
