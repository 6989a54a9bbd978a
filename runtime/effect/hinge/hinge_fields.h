// What a lesson says of an axis that a solid body turns about.
#pragma once

#include "haptics/dynamics/axle.h"
#include "runtime/effect/field_list.h"
#include "runtime/scene/lesson_limits.h"

namespace fulcrum::runtime::fields {

using enum ParameterType;

inline constexpr std::tuple kHinge{
    field(&AxleSettings::axis_W,
          {"axis", vector, "", -1, 1, kRequired,
           "along which it lies: {0, 0, 1} points at you, as of a lever, {0, 1, 0} stands upright, "
           "as "
           "of a door; when it points at you, angles grow counter-clockwise"}),
    argument(
        {"at", vector, "metres", -kMaxCoordinate_m, kMaxCoordinate_m, "nil",
         "a place that the axis passes through, at most 100 m from the body; where the body is by "
         "default"}),
    field(&AxleSettings::inertia_kg_m2, {"inertia", number, "kilogram square metres",
                                         kLeastAxleInertia_kg_m2, kMostAxleInertia_kg_m2, kRequired,
                                         "how hard it is to turn, with all that hangs on it; a "
                                         "body with a mass is harder to turn on a "
                                         "support farther from its middle"}),
    field(&AxleSettings::friction_Nm, {"friction", number, "newton metres", 0, kMostAxleFriction_Nm,
                                       "0", "the torque that brakes it"}),
    field(&AxleSettings::lowest_rad,
          {"lowest", number, "degrees", -1e6, 1e6, "nil", "it turns no further; no end by default"},
          kPerDegree),
    field(
        &AxleSettings::highest_rad,
        {"highest", number, "degrees", -1e6, 1e6, "nil", "it turns no further; no end by default"},
        kPerDegree),
    field(&AxleSettings::load_N,
          {"load", number, "newtons", 0, kMostAxleLoad_N, "0", "a weight that hangs on it"}),
    argument(
        {"load_at", vector, "metres", -kMaxCoordinate_m, kMaxCoordinate_m, "nil",
         "where it hangs at first, at most 100 m from the body; where the body is by default"})};

}  // namespace fulcrum::runtime::fields
