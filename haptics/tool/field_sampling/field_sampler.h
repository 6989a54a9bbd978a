// A tool of many points against a distance field: every point inside pushes out, and only what may touch is looked at.
//
//   force on the tool   sum over points inside of k D n     D the depth, also beyond the band (distance_field.h)
//   torque about T      sum of r x k D n
//   n   slopes, the default   minus the gradient of D: k D^2 / 2 is a potential, and no closed way of the tool gains energy
//       normals               the point's own normal: a tool of few points is pushed as its shape is, but a closed way may gain some
//                             hundredths of the work done on it
// Modes, all with the same contacts and forces where the object's mesh is closed (distance_field.h):
//   brute_force   every leaf of 32 points, every time
//   tree          from the top; a ball that has slack (ball_slack.h) is left out with all below it (shell_search.h)
//   coherent      the same, and each ball, leaf or group remembers until when it is free (free_memory.h, seen_leaves.h). At rest almost
//                 nothing is asked, and when all moves far it is the tree
// Object and tool may both move: all happens in the object's frame O.
// Asked again at the pose it was asked at last, as solvers do, it knows: derivatives alone are taken anew (last_look.h).
//
// With a budget a look ends in time (look_time.h, budget_look.h) and says how far it may be off for what it left out (look_error.h).
// Several looks may share the time of one step (step_time.h), as a solver's do; the first in which not all fits chooses for all.
//
// Thread: one at a time; build at load. Cost: a leaf 0.07 us in the cache and 0.17 beyond it, a group of 8 balls 0.03 us; memory of a
// point 5 bytes, with a budget 8, and 8 a brick of the field's block.
// Source: W. McNeely, K. Puterbaugh, J. Troy 2006, Voxel-based 6-DOF haptic rendering improvements, Haptics-e 3(7), section 4
// (temporal coherence); J. Barbic, D. James 2008, Six-DoF haptic rendering of contact between geometrically complex reduced
// deformable models, IEEE Trans. Haptics 1(1), sections 4.2 and 4.3 (nested points, graceful degradation).
#pragma once

#include "haptics/math/wrench_jacobian.h"
#include "haptics/tool/field_sampling/budget_look.h"
#include "haptics/tool/field_sampling/field_sampling_settings.h"
#include "haptics/tool/field_sampling/field_slopes.h"
#include "haptics/tool/field_sampling/field_sweep.h"
#include "haptics/tool/field_sampling/field_touch.h"
#include "haptics/tool/field_sampling/last_look.h"

namespace fulcrum {

class FieldSampler {
  public:
    using Field = SampledPair::Field;
    using Shell = SampledPair::Shell;
    static constexpr double kNearTouch_voxels = FieldSweep::kNearTouch_voxels;
    static constexpr int kMaxAdvances = FieldSweep::kMaxAdvances;

    /// Refuses settings that `validate` refuses, and neither may be null.
    [[nodiscard]] static Expected<FieldSampler> build(Field field, Shell shell,
                                                      const FieldSamplingSettings& settings = {});

    /// Object at X_WO, tool at X_WT. A pose that is not finite, that turns by no unit quaternion, or a million voxels away, gives no
    /// force, and all is looked at anew afterwards.
    [[nodiscard]] FieldTouch step(const Pose& X_WO, const Pose& X_WT) noexcept {
        return look(X_WO, X_WT, nullptr);
    }
    /// The same; adds the wrench's derivatives by the tool's pose, W, rows and columns as in wrench_jacobian.h. Without a
    /// budget exact within a cell of the field; jumps from cell to cell by the surface's bend.
    [[nodiscard]] FieldTouch step_linearised(const Pose& X_WO, const Pose& X_WT,
                                             Matrix6& by_pose_W) noexcept;

    /// The share of the way from one pose of the tool to the other, in the object's frame, that may be gone before a point comes
    /// deeper than `deepest_m` (0 to 3/4 of the band; what a penalty force needs to push back) or, if it was deeper at the start,
    /// deeper than it was: straight for the origin, about one axis at an even rate. 1: all of it, always so for a motion that
    /// leaves; 0: none, or a pose that `step` refuses. Ends within `kNearTouch_voxels` before that, or short of it after
    /// `kMaxAdvances` advances of a tenth of a voxel at least; a motion that slides takes no longer ones. However often it is
    /// called, no point that was not comes deeper than `deepest_m` by 0.05 voxels.
    [[nodiscard]] double find_first_touch(const Pose& from_OT, const Pose& to_OT,
                                          double deepest_m = 0.0) noexcept;

    /// From now on looks, by whichever function, are those of one step: with a budget they share its time among `n_near` objects
    /// and look where the first one chose. Null: each is a step of its own again. `time` must live until then.
    void begin_step(StepTime* time, int n_near = 1) noexcept;

    /// Forgets what was known to be free.
    void reset() noexcept;

    [[nodiscard]] const FieldSamplingSettings& settings() const noexcept { return settings_; }
    [[nodiscard]] const DistanceField& field() const noexcept { return *pair_.field; }
    [[nodiscard]] const ShellTree& shell() const noexcept { return *pair_.shell; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    FieldSampler(Field field, Shell shell, const FieldSamplingSettings& settings);
    [[nodiscard]] FieldTouch look(const Pose& X_WO, const Pose& X_WT, FieldSlopes* slopes) noexcept;
    [[nodiscard]] FieldTouch look_again(const FieldLook& at, FieldSlopes* slopes) noexcept;
    void take(const FieldLook& at, bool slopes_follow) noexcept;
    void take_all(const FieldLook& at) noexcept;
    [[nodiscard]] FieldTouch tell(const Pose& X_WO) const noexcept;

    FieldSamplingSettings settings_;
    SampledPair pair_;
    LookStages stages_;
    BudgetLook budget_;  // has room where there is a budget
    LastLook last_;
};

}  // namespace fulcrum
