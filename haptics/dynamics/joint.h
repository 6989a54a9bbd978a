// A joint as rows of a contact problem.
//
//   ball      p_b - p_a = 0                      three rows along the world's axes
//   hinge     and axis_b x axis_a = 0            two more, across the axis
//   slider    p_b - p_a along the axis alone, no turn      two rows across, three of turning
//   fixed     p_b - p_a = 0, no turn             six
//   distance  |p_b - p_a| = length               one, along the rod
// p are the anchors, r their arms from the centres of mass; a row along e has J_b = (e, r_b x e), J_a = -(e, r_a x e), one about e
// J_b = (0, e), J_a = -(0, e). A hinge's angle and a slider's travel q have a row each for
//   motor     q' = speed with at most force h;   friction: q' = 0 with at most friction h;   both are one row
//   limits    q' >= -(q - lower) / h  and  <= (upper - q) / h:  a row for each that is finite
// A hinge's angle is told by its axes up to whole turns: the turn nearest to the last step's angle counts, so limits may lie beyond pi, and
// a step that turns by less than pi is seen as what it is.
// Equations hold where the bodies are at the step's end, with J as at its start (SHAKE): u = -(e_ahead - e) / h + J v, where e_ahead is
// the error that velocities v would lead to: first those without the joint, then the answer's, a few times, until the way bends as it was
// told. So no energy is lost to it. What turns far goes in parts of the step (island_stepper.h). Where a body still turns by more than
// 0.6 rad, not about its anchor, there is no such way: u = 0, which loses energy and never gains any. What is left of error is moved away
// in the push that parts overlapping bodies (island_solver.h).
//
// Thread: that of the island. Cost: some 50 ns a row; no allocation.
// Source: the rows are those of any textbook of multibody dynamics; limits as complementarity, D. Baraff 1994;
// J.-P. Ryckaert, G. Ciccotti, H. Berendsen 1977, J. Comp. Phys. 23 (SHAKE).
#pragma once

#include "haptics/base/error.h"
#include "haptics/constraint/contact_problem.h"
#include "haptics/dynamics/joint_plan.h"
#include "haptics/dynamics/rigid_state.h"

#include <array>
#include <string>

namespace fulcrum {

inline constexpr int kMostJointRows = 8;

struct Joint {
    JointKind kind = JointKind::ball;
    std::int32_t body_a = -1;
    std::int32_t body_b = -1;
    bool bodies_touch = false;
    JointDrive drive{};
    double length_m = 0.0;  ///< of a distance joint
    int n_rows = 0;         ///< that it makes, each step as many
    /// Of the anchor, x along the axis, in each body's principal frame; in the world where the body is -1.
    Pose frame_a{};
    Pose frame_b{};
    // What a step changes: impulses of the last one, row by row.
    std::array<double, kMostJointRows> impulses{};
    double travel = 0.0;  ///< of a hinge, where the last step began
};

/// Refuses an axis without length, a distance of 0, drives that are none or out of their ranges, bodies that are not there or the same.
[[nodiscard]] Expected<void> validate(const JointPlan& plan, std::int32_t n_bodies,
                                      const std::string& where);
/// Of bodies that stand so; `a` is not asked for where body_a is -1, and likewise b.
[[nodiscard]] Joint make_joint(const JointPlan& plan, const Pose& a_W, const Pose& b_W);

/// The rows of one step, and how far each is from where it should be.
struct JointRows {
    std::array<RowConstraint, kMostJointRows> rows{};
    std::array<double, kMostJointRows>
        errors{};  ///< m or rad, as u integrates to; 0 of motors and of limits that are not passed
    int count = 0;
};

/// `a_W` and `b_W` are principal poses, the identity of the world. The rows' bodies are for the caller to set.
void make_joint_rows(const Joint& joint, const Pose& a_W, const Pose& b_W, double dt_s,
                     JointRows& rows) noexcept;

/// Where a hinge or a slider is: radians or metres from where it was at the start; 0 of others.
[[nodiscard]] double compute_joint_travel(const Joint& joint, const Pose& a_W,
                                          const Pose& b_W) noexcept;

}  // namespace fulcrum
