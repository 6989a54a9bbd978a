// A node of contact levels, with what it tells: r, s, D, phi and h as contact_levels.h explains them.
#pragma once

#include "haptics/math/spatial.h"

#include <cstdint>

namespace fulcrum {

struct LevelNode {
    std::int32_t first_child = 0;  ///< children stand side by side
    std::int32_t n_children = 0;   ///< 0: a leaf
    std::int32_t level = 0;        ///< 0: the mesh itself
    bool is_bound_only = false;
    Vector3 centre_B{Vector3::Zero()};  ///< of a sphere round the hull
    double radius_m = 0.0;
    double outside_m = 0.0;         ///< h
    double deviation_m = 0.0;       ///< s
    double detail_m3 = 0.0;         ///< phi
    double support_m2 = 0.0;        ///< D
    double resolution_per_m = 0.0;  ///< r, infinite of a leaf
    /// Mean of the normals below: its length is 1 of what is flat, 0 of what is closed.
    Vector3 normal_B{Vector3::Zero()};
    /// Cosine of an angle that no normal below, nor beside it, is farther from it than.
    double cone_cosine = -1.0;
};

}  // namespace fulcrum
