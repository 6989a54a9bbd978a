// A tool of many points against a distance field: every point inside pushes out, and only what may touch is looked at.
//
//   force on the tool   sum over points inside of k d n,  d = max(-F, 0)     (distance_field_batch.h: n the point's own normal,
//   torque about T      sum of r x k d n                                      or the field's slope)
// Modes, all with the same contacts and forces where the object's mesh is closed (distance_field.h):
//   brute_force   every leaf of 32 points, every time
//   tree          from the top; a ball that has slack (ball_slack.h) is left out with all below it
//   coherent      the same, and each ball, leaf or group remembers until when it is free: with m(t) the sum of the tool's motions
//                 so far (largest way of any point in the object's frame), a ball with slack s at m is free until m + s; a leaf that
//                 was looked at, until m + min F / L; a group, until the first of its parts is not. At rest almost nothing is
//                 asked, and when all moves far it is the tree
// Object and tool may both move: all happens in the object's frame O.
//
// With a budget no more leaves are taken than fit in it at `leaf_us` and `group_us`: exactly where that is enough; else thinned
// out, one point for 2^m that lie together, with m the least that fits, so that the nodes that may touch are all visited. The error
// of the sum is estimated by halves: sums over two interleaved halves of the points taken differ by about as much as each is off.
//
// `find_first_touch` follows a motion by conservative advancement: the tool may go on by as much as is free around it.
//
// Thread: one at a time; build at load. Cost: a leaf 0.1 us in the cache and 0.3 beyond it, a group of 8 balls 0.03 us; memory 5 bytes a point.
// Source: W. McNeely, K. Puterbaugh, J. Troy 2006, Voxel-based 6-DOF haptic rendering improvements, Haptics-e 3(7), section 4
// (temporal coherence); J. Barbic, D. James 2008, Six-DoF haptic rendering of contact between geometrically complex reduced
// deformable models, IEEE Trans. Haptics 1(1), sections 4.2 and 4.3 (nested points, graceful degradation); the sweep: B. Mirtich 1996,
// Impulse-based dynamic simulation, PhD thesis, Berkeley, section 2.3.2.
#pragma once

#include "haptics/math/wrench_jacobian.h"
#include "haptics/voxel/ball_slack.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace fulcrum {

enum class SamplingMode : std::uint8_t { brute_force, tree, coherent };

/// Fixed at load.
struct FieldSamplingSettings {
    double stiffness_N_per_m = 100.0;  ///< k of one point, 0 to 1e6
    ForceAlong along = ForceAlong::normals;
    SamplingMode mode = SamplingMode::coherent;
    double budget_us =
        0.0;  ///< of a step, 0: as long as it takes; else 5 to 1e5; not with brute force
    double leaf_us =
        0.3;  ///< what a leaf of points is taken to cost, 0.01 to 10; more than in the cache
    double group_us = 0.06;  ///< what a group of balls is taken to cost, 0.01 to 10
};

/// Checks all fields.
[[nodiscard]] Expected<void> validate(const FieldSamplingSettings& settings);

/// What a step found.
struct FieldTouch {
    Wrench wrench_W;              ///< on the tool, about its frame's origin
    std::int64_t n_touching = 0;  ///< points inside; with a weight, those that were taken times it
    double deepest_m = 0.0;       ///< of the points taken
    std::int64_t weight = 1;    ///< points that each point taken stands for; 1: all were looked at
    double error_N = 0.0;       ///< about how far the force is off for it; 0 at weight 1
    std::int64_t n_leaves = 0;  ///< taken
    std::int64_t n_groups = 0;  ///< of balls, looked at
};

class FieldSampler {
  public:
    using Field = std::shared_ptr<const DistanceField>;
    using Shell = std::shared_ptr<const ShellTree>;

    /// Refuses settings that `validate` refuses, and neither may be null.
    [[nodiscard]] static Expected<FieldSampler> build(Field field, Shell shell,
                                                      const FieldSamplingSettings& settings = {});

    /// Object at X_WO, tool at X_WT. A pose that is not finite, or a million voxels away, gives no force, and all is looked at anew afterwards.
    [[nodiscard]] FieldTouch step(const Pose& X_WO, const Pose& X_WT) noexcept;

    /// The share of the way from one pose of the tool to the other, in the object's frame, that is surely free: straight for the
    /// origin, about one axis at an even rate. 1: all of it; 0: the tool touches at the start. Ends within `kNearTouch_voxels`
    /// before a touch, or short of it after `kMaxAdvances` steps.
    [[nodiscard]] double find_first_touch(const Pose& from_OT, const Pose& to_OT) noexcept;

    /// The same as `step`; adds the wrench's derivatives by the tool's pose, W, rows and columns as in wrench_jacobian.h. Exact
    /// within a cell of the field, jumps from cell to cell by the surface's bend.
    [[nodiscard]] FieldTouch step_linearised(const Pose& X_WO, const Pose& X_WT,
                                             Matrix6& by_pose_W) noexcept;

    /// Forgets what was known to be free.
    void reset() noexcept;

    [[nodiscard]] const FieldSamplingSettings& settings() const noexcept { return settings_; }
    [[nodiscard]] const DistanceField& field() const noexcept { return *field_; }
    [[nodiscard]] const ShellTree& shell() const noexcept { return *shell_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

    static constexpr double kNearTouch_voxels = 0.05;
    static constexpr int kMaxAdvances = 200;

  private:
    // Ascending; as long as it can get from the start.
    class Nodes {
      public:
        void reserve(std::size_t n) { nodes_.resize(n); }
        void clear() noexcept { n_ = 0; }
        void add(std::int32_t node) noexcept { nodes_[n_++] = node; }
        void copy(const Nodes& other) noexcept {
            std::copy(other.begin(), other.end(), nodes_.data());
            n_ = other.n_;
        }
        [[nodiscard]] std::size_t size() const noexcept { return n_; }
        [[nodiscard]] const std::int32_t* begin() const noexcept { return nodes_.data(); }
        [[nodiscard]] const std::int32_t* end() const noexcept { return nodes_.data() + n_; }
        [[nodiscard]] std::size_t memory_bytes() const noexcept {
            return nodes_.capacity() * sizeof(std::int32_t);
        }

      private:
        std::vector<std::int32_t> nodes_;
        std::size_t n_ = 0;
    };
    static constexpr float kAlways = -1.0e30F;

    struct Level {
        std::vector<float> free_until;  // a node's, on the clock of motion, voxels
        Nodes groups;                   // to be looked at in this step
    };
    // What is to be taken: nodes of a level, as units of 2^merge of them.
    struct Choice {
        std::size_t level = 0;  // of the nodes in `nodes_`; 0: leaves
        std::size_t merge = 0;
    };

    FieldSampler(Field field, Shell shell, const FieldSamplingSettings& settings);
    void advance_clock(const Pose& X_OT) noexcept;
    void rebase_clock() noexcept;
    // The whole shell, to be searched.
    void begin_at_top() noexcept;
    // Nodes of `level` in its groups that may touch within `within` voxels, to `nodes_`; the least slack of the others.
    float search_level(std::size_t level, const FieldPlace& place, bool remembers,
                       float within) noexcept;
    // Down from the top as far as the budget lets it.
    Choice search(const FieldPlace& place) noexcept;
    [[nodiscard]] std::size_t count_units(std::size_t merge) const noexcept;
    void take_all_leaves(const FieldPlace& place, const Pose& X_OT) noexcept;
    void take_leaves(const FieldPlace& place, const Pose& X_OT) noexcept;
    void take_units(const Choice& choice, const FieldPlace& place, const Pose& X_OT) noexcept;
    float take_leaf(std::size_t thinning, std::size_t leaf, const FieldPlace& place,
                    const Pose& X_OT) noexcept;
    void add_slopes(std::size_t thinning, std::size_t leaf, const FieldPlace& place,
                    const Pose& X_OT) noexcept;
    void empty_lanes(const Pose& X_OT) noexcept;
    void remember_groups() noexcept;
    [[nodiscard]] double bound_clearance_voxels(const Pose& X_OT) noexcept;

    Field field_;
    Shell shell_;
    FieldSamplingSettings settings_;
    SlackBounds bounds_;
    const FieldKernels* kernels_;
    std::vector<Level> levels_;
    Nodes nodes_;
    double clock_voxels_ = 0.0;
    float now_ = 0.0F;  // the clock, rounded up
    Pose last_OT_;
    bool has_last_ = false;
    // While a step runs.
    ContactLanes lanes_;
    int n_in_lanes_ = 0;
    ContactSums sums_;
    ContactSums half_difference_;
    float deepest_steps_ = 0.0F;
    FieldTouch touch_;
    Matrix6* slopes_O_ = nullptr;  // where derivatives are asked for; over the stiffness
};

}  // namespace fulcrum
