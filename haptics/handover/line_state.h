// What a kite's line does, as its own loop tells it.
#pragma once

#include "haptics/math/spatial.h"

#include <cstdint>

namespace fulcrum {

/// World -> haptic loop, newest value.
struct LineState {
    double stamp_s = -1.0;  ///< when it was so, on the run's clock; before the first negative
    Vector3 hand_W{Vector3::Zero()};   ///< where the hand was then, metres
    Vector3 force_W{Vector3::Zero()};  ///< on the hand, newtons
    double stiffness_N_per_m = 0.0;    ///< k
    double length_m = 1.0;             ///< L, above 0
    std::uint32_t n_launches = 0;      ///< how often the kite was launched
};

}  // namespace fulcrum
