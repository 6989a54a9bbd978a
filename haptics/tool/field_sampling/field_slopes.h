// How the force of field sampling (field_sampler.h) changes with the tool's pose. For a point at r from the tool's origin, g = -grad D the
// way out, H the second derivatives of D, B = (I; [r]) what a force at the point is as a wrench:
//   slopes    f = k D g        dW = -k B (g g^T + D H) B^T dx + (0; [f][r] dtheta)      in vectors; slope_sum.h row by row
//   normals   f = k D n        dW = -k (n; r x n) (g; r x g)^T dx, and f turns with the tool
// Of the leaves that touch; with a budget of one in n of them, times n, the least n that fits in the time that is left.
//
// Thread: that of the step. Cost: a leaf that touches four times what its force costs, by normals sixteen times.
#pragma once

#include "haptics/math/wrench_jacobian.h"
#include "haptics/tool/field_sampling/leaf_sums.h"
#include "haptics/tool/field_sampling/look_time.h"

namespace fulcrum {

class FieldSlopes {
  public:
    explicit FieldSlopes(ForceAlong along) noexcept : along_(along) {}

    /// Of what a look took.
    void add_all(const FieldLook& look, const LeafSums& sums, LookTime& time) noexcept;
    /// Adds the derivatives of a wrench in W, of which `touch` told, the object turned as it is there.
    void add_to(Matrix6& by_pose_W, const Pose& X_WO, const FieldTouch& touch,
                double stiffness_N_per_m) const noexcept;

  private:
    void add_leaf(const FieldLook& look, const ShellPoints& points, std::size_t n) noexcept;
    void add_leaf_by_normals(const FieldLook& look, const ShellPoints& points,
                             std::size_t n) noexcept;

    ForceAlong along_;
    Matrix6 slopes_O_{Matrix6::Zero()};  // over the stiffness
    SlopeLanes lanes_;
};

}  // namespace fulcrum
