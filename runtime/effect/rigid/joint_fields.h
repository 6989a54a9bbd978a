// What a lesson says of how a rigid body hangs on another one, or on the world.
#pragma once

#include "runtime/effect/field_list.h"
#include "runtime/scene/description.h"
#include "runtime/scene/lesson_limits.h"

namespace fulcrum::runtime::fields {

using enum ParameterType;

inline constexpr double kMostJointTravel = 1e4;  ///< degrees or metres, a second too

inline constexpr std::tuple kJoint{
    argument({"kind", choice, "", 0, 0, kRequired,
              "a hinge turns about its axis, a slider moves along it, a ball turns every way "
              "about its "
              "place, a rod holds two places as far apart as they are, fixed is glued",
              "hinge slider ball fixed rod"}),
    argument({"to", name, "", 0, 0, "nil",
              "the name of a rigid body that was declared before; the world by default"}),
    argument({"at", vector, "metres", -kMaxCoordinate_m, kMaxCoordinate_m, "nil",
              "where it is; of a rod its end on the other body; where the body is by default"}),
    argument({"end_at", vector, "metres", -kMaxCoordinate_m, kMaxCoordinate_m, "nil",
              "of a rod: its end on this body; where the body is by default"}),
    field(&JointDescription::axis_W,
          {"axis", vector, "", -1, 1, "{0, 0, 1}",
           "of a hinge or slider: {0, 0, 1} points at you, {0, 1, 0} stands upright"}),
    argument({"lowest", number, "degrees, metres of a slider", -kMostJointTravel, 0, "nil",
              "it goes no further; no end by default"}),
    argument({"highest", number, "degrees, metres of a slider", 0, kMostJointTravel, "nil",
              "it goes no further; no end by default"}),
    argument({"speed", number, "degrees or metres per second", -kMostJointTravel, kMostJointTravel,
              "0", "of its motor"}),
    field(&JointDescription::force, {"force", number, "newtons, newton metres of a hinge", 0, 1e4,
                                     "0", "that its motor has; 0 is no motor"}),
    field(&JointDescription::friction, {"friction", number, "newtons, newton metres of a hinge", 0,
                                        1e4, "0", "what brakes it"})};

}  // namespace fulcrum::runtime::fields
