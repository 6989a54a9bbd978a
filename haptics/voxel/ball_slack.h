// How far eight balls of a tool may each move before a distance field could be 0 anywhere in them: the law of FieldKernels::find_slacks.
//
//   slack = max(F / L, D - e) - r - margin      voxels; F at the ball's centre, L the field's slope bound, D a lower bound of the
//                                               distance to the mesh (distance_field.h), e the field's error bound
// At most 0: the ball may touch, no deeper than -L slack; where F is at most 0 at the centre, slack = F / L - r - margin. The
// margin covers single precision.
//
// Thread: any; no state. Cost: 20 to 30 ns for eight in the cache.
#pragma once

#include "haptics/voxel/shell_tree.h"

namespace fulcrum {

/// What of a field does not change while balls are asked for, in voxels.
struct SlackBounds {
    explicit SlackBounds(const DistanceField& field) noexcept;

    FieldView view;
    float voxels_per_step;
    float voxels_per_metre;
    float inverse_slope;  ///< 1 / L
    float error;
    std::array<float, 3> ball_centre;  ///< of a ball that holds the mesh
    float ball_radius;
};

}  // namespace fulcrum
