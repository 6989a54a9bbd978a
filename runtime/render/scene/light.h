// The one lamp: a warm key light, and the window its shadows are seen through. Shadows fall nearly
// straight down, so that they show where a thing will land; shading comes more from the side, so
// that it shows the shape.
//
// Thread: any; values. Cost: a few dozen multiplications.
#pragma once

#include "runtime/render/camera.h"

namespace fulcrum::runtime {

/// How far shadows reach on the floor, as a part of the camera's distance.
inline constexpr double kLightReach = 0.85;

/// A light from infinitely far away, and the square on the floor that its shadow map covers.
struct Light {
    Vector3f to_light{Vector3f::UnitY()};              ///< for shading; unit length, world
    Vector3f to_lamp{Vector3f::UnitY()};               ///< for shadows; unit length, world
    Matrix4f clip_from_world{Matrix4f::Identity()};    ///< for drawing the map
    Matrix4f shadow_from_world{Matrix4f::Identity()};  ///< 0 to 1 in x y z
    Vector3f centre_W{Vector3f::Zero()};               ///< on the floor
    float reach_m = 1.0F;  ///< the floor within this of the centre is covered
    float texel_m = 0.0F;  ///< side of a shadow map texel
};

/// The light for what a camera looks at, over a floor at a height.
[[nodiscard]] Light light_for(const Camera& camera, double ground_height_m, int shadow_map_size);

}  // namespace fulcrum::runtime
