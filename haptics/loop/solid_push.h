// How a hand presses a solid, with a point or with a tool.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

struct SolidPush {
    bool touches = false;
    Vector3 at_W{Vector3::Zero()};
    Vector3 force_W{Vector3::Zero()};   ///< on the solid, at that place
    Vector3 couple_W{Vector3::Zero()};  ///< on it as well, wherever
};

/// What a hand may feel next (SafetyGate::find_most_N and find_most_Nm), seen in the world.
struct MostFelt {
    double force_N = 0.0;
    double torque_Nm = 0.0;
};

}  // namespace fulcrum
