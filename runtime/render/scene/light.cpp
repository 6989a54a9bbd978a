#include "runtime/render/scene/light.h"

#include <cmath>

namespace fulcrum::runtime {

namespace {

const Vector3 kToLight = Vector3(-0.45, 1.0, 0.65).normalized();
const Vector3 kToLamp = Vector3(-0.03, 1.0, 0.05).normalized();
constexpr double kLampHeight = 4.0;  // of the reach; what is above it still casts a shadow
constexpr double kDepthRange = 6.0;  // of the reach, from the lamp down

}  // namespace

Light light_for(const Camera& camera, double ground_height_m, int shadow_map_size) {
    Light light;
    const double reach_m = kLightReach * camera.distance_m();
    const double ground = std::isfinite(ground_height_m) ? ground_height_m : 0.0;
    const Vector3 centre(camera.target_W().x(), ground, camera.target_W().z());

    // Right-handed axes that look along the light.
    const Vector3 back = kToLamp;
    const Vector3 right = Vector3::UnitY().cross(back).normalized();
    const Vector3 up = back.cross(right);
    const Vector3 lamp = centre + kLampHeight * reach_m * back;
    Matrix4 view = Matrix4::Identity();
    view.block<1, 3>(0, 0) = right.transpose();
    view.block<1, 3>(1, 0) = up.transpose();
    view.block<1, 3>(2, 0) = back.transpose();
    view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * lamp;

    // A box of light, 10 % wider than the floor that it must cover.
    const double half_m = 1.1 * reach_m;
    Matrix4 box = Matrix4::Identity();
    box(0, 0) = 1.0 / half_m;
    box(1, 1) = 1.0 / half_m;
    box(2, 2) = -2.0 / (kDepthRange * reach_m);
    box(2, 3) = -1.0;

    Matrix4 to_unit = 0.5 * Matrix4::Identity();
    to_unit.block<3, 1>(0, 3).setConstant(0.5);
    to_unit(3, 3) = 1.0;

    light.to_light = kToLight.cast<float>();
    light.to_lamp = kToLamp.cast<float>();
    light.clip_from_world = (box * view).cast<float>();
    light.shadow_from_world = (to_unit * box * view).cast<float>();
    light.centre_W = centre.cast<float>();
    light.reach_m = static_cast<float>(reach_m);
    light.texel_m = static_cast<float>(2.0 * half_m / shadow_map_size);
    return light;
}

}  // namespace fulcrum::runtime
