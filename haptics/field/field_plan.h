// A force field as a scene declares it. The law of each kind stands in the header of the same name
// beside this file.
#pragma once

#include "haptics/math/spatial.h"

#include <cstdint>

namespace fulcrum {

enum class FieldKind : std::uint8_t { spring, viscosity, magnet };

/// A force field declared by the scene; fixed at load.
struct FieldPlan {
    FieldKind kind = FieldKind::spring;
    Vector3 anchor_W{Vector3::Zero()};  ///< spring, magnet: metres
    double stiffness_N_per_m = 0.0;     ///< spring: 0 to 2000
    double damping_Ns_per_m = 0.0;      ///< spring, viscosity: 0 to 50
    double peak_force_N = 0.0;          ///< magnet: largest pull, 0 to the force limit
    double range_m = 0.1;               ///< magnet: distance of the largest pull
};

}  // namespace fulcrum
