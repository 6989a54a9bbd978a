// What a look of a tool's points at a distance field found (field_sampler.h).
#pragma once

#include "haptics/math/spatial.h"

#include <cstdint>

namespace fulcrum {

/// What was looked at.
struct LookWork {
    std::int64_t n_leaves = 0;  ///< taken
    std::int64_t n_groups = 0;  ///< of balls, looked at
    std::int64_t n_sloped = 0;  ///< leaves whose derivatives were taken
};

struct FieldTouch : LookWork {
    Wrench wrench_W;              ///< on the tool, about its frame's origin
    std::int64_t n_touching = 0;  ///< points inside; with a weight, those that were taken times it
    double deepest_m = 0.0;       ///< of the points taken
    std::int64_t weight = 1;  ///< points that each point taken stands for; 1: all were looked at
    double error_N =
        0.0;  ///< how far the force is off for what was left out, on the safe side; 0: nothing was
    double error_Nm = 0.0;    ///< the torque about the tool's origin
    double bound_N = 0.0;     ///< surely off by no more
    double bound_Nm = 0.0;    ///< likewise the torque
    std::int64_t n_left = 0;  ///< nodes that may touch and were left out
};

}  // namespace fulcrum
