// Whether an explicit integrator holds a tool on its coupling and against what it meets, or shakes it: known before it runs.
//
//   M x'' + C x' + K x = 0   about a tool at rest, x its shift and turn,  M = diag(m, I)
//   coupling   k and b at the grip, k_r and B_r:  J = (1, -[g])  gives  J^T k J,  J^T b J
//   contact    k_p sum J J^T,  J = (u, p x u),  over the points that touch where two planes across u hold the tool between them,
//              each pressing with the most force F that a hand gives: those within the depth d with k_p sum of depths = F. Among
//              voxels springs act along the points' normals instead of u. Tried across 13 axes and 32 of the points' own normals,
//              whole and in parts, for a contact begins with few points
//   brakes     of voxels: M / (2 h) besides
// A step is linear in it, (x, v) -> A (x, v), with h the step and L = [0 1; -M^-1 K  -M^-1 C]:
//   explicit Euler  1 + hL      semi-implicit Euler, Verlet  their two and three lines      RK4  1 + hL + ... + (hL)^4 / 24
// and holds where no eigenvalue of A is longer than 1. Of one mode (m, b, k) that is
//   explicit Euler        h k <= b          where b^2 <= 4 m k, so that no mass is enough without a damper
//   semi-implicit Euler   h^2 k/m + 2 h b/m <= 4
//   Verlet                h^2 k/m <= 4      undamped
//   RK4                   h^2 k/m <= 8      undamped;  h b/m <= 2.785 without a spring
// A lighter tool, a thinner one (its turn), more points and a stiffer spring all come nearer to the limit. Where a tool fits its
// hole on all sides more points may touch than between two planes: that is not reckoned with. Backward Euler and a tool without
// mass have no limit.
//
// Thread: load path. Cost: 20 ms for each question and 2 us a point.
// Source: E. Hairer, G. Wanner 1996, Solving Ordinary Differential Equations II, section IV.2 (regions of stability).
#pragma once

#include "haptics/tool/tool_plan.h"

#include <optional>
#include <vector>

namespace fulcrum {

class StepLimit {
  public:
    /// Of a plan's tool, whose points `shell` has as its order had them.
    StepLimit(const ToolPlan& plan, const Pointshell& shell);

    /// The largest factor by which a step of `dt_s` makes a small motion longer; above 1 it shakes, 0 where there is no limit.
    [[nodiscard]] double compute_growth(const VoxelToolSettings& settings, double dt_s) const;
    [[nodiscard]] bool holds(const VoxelToolSettings& settings, double dt_s) const;
    /// The least mass of the same shape with which it holds, at most `most_kg` and at least the settings' own.
    [[nodiscard]] std::optional<double> find_least_mass_kg(const VoxelToolSettings& settings,
                                                           double dt_s, double most_kg) const;

  private:
    std::vector<Matrix6> contacts_;  // stiffness of each, T
    bool brakes_;
};

/// `settings` with that mass, and moments that go with it.
[[nodiscard]] VoxelToolSettings make_heavier(VoxelToolSettings settings, double mass_kg);

}  // namespace fulcrum
