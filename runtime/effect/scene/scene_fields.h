// What a lesson says of its scene: how strongly things fall, the ground, the camera.
#pragma once

#include "runtime/effect/field_list.h"
#include "runtime/scene/description.h"
#include "runtime/scene/lesson_limits.h"

namespace fulcrum::runtime::fields {

using enum ParameterType;

inline constexpr std::tuple kGravity{field(
    [](auto& scene) -> auto& { return scene.gravity_W[1]; },
    {"acceleration", number, "metres per second squared", 0, 100, kRequired,
     "downwards; 9.81 on Earth, 1.62 on the Moon"},
    -1.0)};

inline constexpr std::tuple kGround{
    field(&LessonDescription::ground_height_m,
          {"height", number, "metres", -100, 100, kRequired, "where bodies land"})};

inline constexpr std::tuple kContacts{
    field(&RigidSolveDescription::method,
          {"method", choice, "", 0, 0, "newton",
           "how the forces between rigid bodies are found, by the name of the method: all at once; "
           "or one after the other until all fit (dantzig); or round after round, nearer each "
           "time (iterative)",
           "newton dantzig iterative"}),
    field(&RigidSolveDescription::friction,
          {"friction", choice, "", 0, 0, "cone",
           "alike in all directions, or as a pyramid of four sides, which holds more along its "
           "corners; dantzig has the pyramid alone",
           "cone pyramid"})};

inline constexpr std::tuple kCamera{
    field(&CameraDescription::eye_W, {"eye", vector, "metres", -kMaxCoordinate_m, kMaxCoordinate_m,
                                      "{0, 0.55, 1.5}", "where the camera is"}),
    field(&CameraDescription::target_W, {"target", vector, "metres", -kMaxCoordinate_m,
                                         kMaxCoordinate_m, "{0, 0.35, 0}", "what it looks at"}),
    field(&CameraDescription::vertical_angle_deg,
          {"angle", number, "degrees", 5, 120, "40", "how much it sees, from top to bottom"})};

}  // namespace fulcrum::runtime::fields
