// A tool of many points against a distance field: every point inside pushes out, and only what may touch is looked at.
//
//   force on the tool   sum over points inside of k D n     D the depth, also beyond the band (distance_field.h)
//   torque about T      sum of r x k D n
//   n   slopes, the default   minus the gradient of D: k D^2 / 2 is a potential, and no closed way of the tool gains energy
//       normals               the point's own normal: a tool of few points is pushed as its shape is, but a closed way may gain some
//                             hundredths of the work done on it
// Modes, all with the same contacts and forces where the object's mesh is closed (distance_field.h):
//   brute_force   every leaf of 32 points, every time
//   tree          from the top; a ball that has slack (ball_slack.h) is left out with all below it
//   coherent      the same, and each ball, leaf or group remembers until when it is free: with m(t) the sum of the tool's motions
//                 so far (largest way of any point in the object's frame), a ball with slack s at m is free until m + s; a leaf that
//                 was looked at, until m + min F / L; a group, until the first of its parts is not. A leaf that is free no longer
//                 by that is by where it was looked at, as long as it went along the surface or away from it (slope_boxes.h). At
//                 rest almost nothing is asked, and when all moves far it is the tree
// Object and tool may both move: all happens in the object's frame O.
// Asked again at the pose it was asked at last, as solvers do, it knows: derivatives alone are taken anew.
//
// With a budget a step ends in time, on the machine's clock or a counted one, and says what it left out:
//   all that may touch fits   it is exact
//   else                      first look: one point for 2^m that lie together, m the least that fits in half of the time. Each sample
//                             tells of the part it stands for: of the parts that have one that touches, as many more that nearly do
//                             and a rim round them, closer looks take its place, as fine as fits in the rest; what time is left then
//                             is given to what is next nearest (seen_samples.h)
//   64 samples touch          their sum times 2^m stands for all. Where closer looks are at each point, that is the sum
//   fewer                     no sum of few stands for many: whole leaves are taken, first what touched in the last step, then
//                             what reaches farthest for its size. A lone tip weighs what it weighs
//   derivatives               of one leaf in n that touch, times n, the least n that fits in what the force leaves of the time,
//                             half of it at least
// Several looks may share the time of one step (step_time.h), as a solver's do. The first in which not all fits chooses: how many
// points one stands for, and which of them are looked at. The others look there again, so that the solver sees one force that
// follows the pose; what has come near since is told as left out.
// What things cost is learned, and how long before the end to stop: a twentieth of the budget, and more after a step that was late. One
// that lost the processor for longer than its budget is late whatever it does: it does what it had planned. A look that was cut short
// tells what the last one did, and so no more than a step long: a surface does not go for a moment because the processor did.
// How far the result may be off:
//   bound    k L_n sum over nodes left out of n D, and the samples' own sum. D = L min(-slack, m - m_free): how deep a node may be
//            by its ball and by when it was free last; where that is beyond 3/4 of the band, a brick's diagonal more, and as deep as
//            anything in the object where its middle may be. n its points, L_n = 1 by normals, L by slopes. For the torque times
//            the tool's reach. Never exceeded for closed meshes; often many times the error
//   error    where samples stand for all, or told where to look: four times the square root of 16/15 sum |X_l - mean|^2 over 16
//            interleaved sums X_l, as if samples were drawn by chance; they are spread evenly, so that the error is less. And for
//            what the first look missed at the rim, 2^m sqrt(N) points half as deep as the deepest, N its leaves that did; at least
//            as much as closer looks changed the sum. Else, and where the clock cut a look short, the bound. In local contact 5 to
//            25 times the true error at the median, in a socket 30 to 60 times
//
// `find_first_touch` follows a motion by conservative advancement: the tool may go on by as much as is free around it. Points that
// touch at the start stop only what takes them deeper; a motion along the surface or out of it is free. So a tool in contact moves,
// and one that is fast does not tunnel through a wall that is more than twice the depth let to it. Where the step's time ends, so does
// the motion: a tenth of a voxel at most beyond what was looked at.
//
// Thread: one at a time; build at load. Cost: a leaf 0.07 us in the cache and 0.17 beyond it, a group of 8 balls 0.03 us; memory 6 bytes a point, with a budget 8,
// and 8 a brick of the field's block.
// Source: W. McNeely, K. Puterbaugh, J. Troy 2006, Voxel-based 6-DOF haptic rendering improvements, Haptics-e 3(7), section 4
// (temporal coherence); J. Barbic, D. James 2008, Six-DoF haptic rendering of contact between geometrically complex reduced
// deformable models, IEEE Trans. Haptics 1(1), sections 4.2 and 4.3 (nested points, graceful degradation); the sweep: B. Mirtich 1996,
// Impulse-based dynamic simulation, PhD thesis, Berkeley, section 2.3.2.
#pragma once

#include "haptics/base/clock.h"
#include "haptics/math/wrench_jacobian.h"
#include "haptics/tool/seen_samples.h"
#include "haptics/tool/step_time.h"
#include "haptics/voxel/ball_slack.h"
#include "haptics/voxel/slope_boxes.h"

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

enum class SamplingMode : std::uint8_t { brute_force, tree, coherent };
/// Fixed at load.
struct FieldSamplingSettings {
    double stiffness_N_per_m = 100.0;  ///< k of one point, 0 to 1e6
    ForceAlong along = ForceAlong::slopes;
    SamplingMode mode = SamplingMode::coherent;
    double budget_us = 0.0;  ///< of a step, 0: as long as it takes; else 5 to 1e5, coherent only
    BudgetClock clock = BudgetClock::measured;
    double leaf_us = 0.3;    ///< what a leaf of points costs, until it is known; 0.01 to 10
    double group_us = 0.06;  ///< what a group of balls costs, likewise
    double (*now_s)() noexcept = &monotonic_now_s;  ///< what is measured by, where no StepTime is
};

/// Checks all fields.
[[nodiscard]] Expected<void> validate(const FieldSamplingSettings& settings);

/// What a step found.
struct FieldTouch {
    Wrench wrench_W;              ///< on the tool, about its frame's origin
    std::int64_t n_touching = 0;  ///< points inside; with a weight, those that were taken times it
    double deepest_m = 0.0;       ///< of the points taken
    std::int64_t weight = 1;  ///< points that each point taken stands for; 1: all were looked at
    double error_N =
        0.0;  ///< how far the force is off for what was left out, on the safe side; 0: nothing was
    double error_Nm = 0.0;  ///< the torque about the tool's origin
    double bound_N = 0.0;   ///< surely off by no more
    double bound_Nm = 0.0;
    std::int64_t n_left = 0;    ///< nodes that may touch and were left out
    std::int64_t n_leaves = 0;  ///< taken
    std::int64_t n_groups = 0;  ///< of balls, looked at
    std::int64_t n_sloped = 0;  ///< leaves whose derivatives were taken
};

class FieldSampler {
  public:
    using Field = std::shared_ptr<const DistanceField>;
    using Shell = std::shared_ptr<const ShellTree>;

    /// Refuses settings that `validate` refuses, and neither may be null.
    [[nodiscard]] static Expected<FieldSampler> build(Field field, Shell shell,
                                                      const FieldSamplingSettings& settings = {});

    /// Object at X_WO, tool at X_WT. A pose that is not finite, that turns by no unit quaternion, or a million voxels away, gives no
    /// force, and all is looked at anew afterwards.
    [[nodiscard]] FieldTouch step(const Pose& X_WO, const Pose& X_WT) noexcept;

    /// The share of the way from one pose of the tool to the other, in the object's frame, that may be gone before a point comes
    /// deeper than `deepest_m` (0 to 3/4 of the band; what a penalty force needs to push back) or, if it was deeper at the start,
    /// deeper than it was: straight for the origin, about one axis at an even rate. 1: all of it, always so for a motion that
    /// leaves; 0: none, or a pose that `step` refuses. Ends within `kNearTouch_voxels` before that, or short of it after
    /// `kMaxAdvances` advances of a tenth of a voxel at least; a motion that slides takes no longer ones. However often it is
    /// called, no point that was not comes deeper than `deepest_m` by 0.05 voxels.
    [[nodiscard]] double find_first_touch(const Pose& from_OT, const Pose& to_OT,
                                          double deepest_m = 0.0) noexcept;

    /// The same as `step`; adds the wrench's derivatives by the tool's pose, W, rows and columns as in wrench_jacobian.h. Without a
    /// budget exact within a cell of the field; jumps from cell to cell by the surface's bend.
    [[nodiscard]] FieldTouch step_linearised(const Pose& X_WO, const Pose& X_WT,
                                             Matrix6& by_pose_W) noexcept;

    /// From now on looks, by whichever function, are those of one step: with a budget they share its time among `n_near` objects
    /// and look where the first one chose. Null: each is a step of its own again. `time` must live until then.
    void begin_step(StepTime* time, int n_near = 1) noexcept;

    /// Forgets what was known to be free.
    void reset() noexcept;

    [[nodiscard]] const FieldSamplingSettings& settings() const noexcept { return settings_; }
    [[nodiscard]] const DistanceField& field() const noexcept { return *field_; }
    [[nodiscard]] const ShellTree& shell() const noexcept { return *shell_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

    static constexpr double kNearTouch_voxels = 0.15;
    static constexpr int kMaxAdvances = 200;

  private:
    // Ascending; as long as it can get from the start.
    class Nodes {
      public:
        void reserve(std::size_t n) { nodes_.resize(n); }
        void clear() noexcept { n_ = 0; }
        void add(std::int32_t node) noexcept { nodes_[n_++] = node; }
        void put(std::size_t i, std::int32_t node) noexcept { nodes_[i] = node; }
        void shorten(std::size_t n) noexcept { n_ = n; }
        void drop_first(std::size_t n) noexcept {
            std::copy(begin() + n, end(), nodes_.data());
            n_ -= n;
        }
        void sort() noexcept { std::sort(nodes_.data(), nodes_.data() + n_); }
        // What is in either, and what is in the first alone; not in place.
        void unite(const Nodes& a, const Nodes& b) noexcept {
            n_ = static_cast<std::size_t>(
                std::set_union(a.begin(), a.end(), b.begin(), b.end(), nodes_.data()) -
                nodes_.data());
        }
        void subtract(const Nodes& a, const Nodes& b) noexcept {
            n_ = static_cast<std::size_t>(
                std::set_difference(a.begin(), a.end(), b.begin(), b.end(), nodes_.data()) -
                nodes_.data());
        }
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
    static constexpr float kFreeMargin_voxels = 2.0e-3F;  // single precision places and clock

    struct Level {
        std::vector<float> free_until;      // a node's, on the clock of motion, voxels
        std::vector<float> hopeless_until;  // a group's: all balls that were asked touch until then
        Nodes groups;                       // to be looked at in this step
    };

    FieldSampler(Field field, Shell shell, const FieldSamplingSettings& settings);
    // A number, a turn, and no farther than the clock of motion can count.
    [[nodiscard]] bool is_within_reach(const Pose& X_OT) const noexcept;
    void advance_clock(const Pose& X_OT) noexcept;
    [[nodiscard]] std::array<float, 3> find_middle(std::size_t leaf,
                                                   const FieldPlace& place) const noexcept;
    // That a leaf was looked at here, its least F being above 0.
    void remember_leaf(std::size_t leaf, float least_voxels, const FieldPlace& place) noexcept;
    void forget_seen() noexcept;
    // How much F is above 0 at least, by where the leaf was looked at; voxels, below 0 where that says nothing.
    [[nodiscard]] float recall_leaf(std::size_t leaf, const FieldPlace& place) const noexcept;
    void rebase_clock() noexcept;
    // The whole shell, to be searched.
    void begin_at_top() noexcept;
    // Nodes of `level` in its groups that may touch within `within` voxels, to `nodes_`; the least slack of the others.
    float search_level(std::size_t level, const FieldPlace& place, bool remembers,
                       float within) noexcept;
    float search_group(std::size_t level, std::size_t group, unsigned due, const FieldPlace& place,
                       bool remembers, float within) noexcept;
    void add_node(std::int32_t node, float depth_voxels) noexcept {
        depths_[nodes_.size()] = depth_voxels;
        nodes_.add(node);
    }
    // Down from the top to the leaves.
    void search(const FieldPlace& place) noexcept;
    // Leaves of a thinning, in ascending order.
    void take(std::size_t thinning, std::span<const std::int32_t> leaves, const FieldPlace& place,
              const Pose& X_OT) noexcept;
    void add_slopes(const ShellPoints& points, std::size_t n, const FieldPlace& place,
                    const Pose& X_OT, SlopeLanes& lanes) noexcept;
    void add_slopes_by_normals(const ShellPoints& points, std::size_t n, const FieldPlace& place,
                               const Pose& X_OT) noexcept;
    // Of the leaves that touch, or evenly of as many as there is time for.
    void add_all_slopes(const FieldPlace& place, const Pose& X_OT) noexcept;
    void empty_lanes(const Pose& X_OT) noexcept;
    void remember_groups() noexcept;
    void finish(const Pose& X_WO) noexcept;
    // A motion, and what each point of it may not pass.
    struct Sweep;
    // How far the points of a leaf may go at `place` at least; below 0 where one is beyond its limit.
    [[nodiscard]] float find_leaf_margin(const Sweep& sweep, const Pose& X_OT,
                                         const FieldPlace& place, std::size_t leaf,
                                         float slack_voxels) noexcept;
    void deepen(const ShellPoints& points, const Pose& X_OT,
                std::span<float> values) const noexcept;
    [[nodiscard]] double find_margin(const Sweep& sweep, double share, float slack_voxels) noexcept;
    [[nodiscard]] double find_end(const Sweep& sweep, double free, double not_free) noexcept;

    // What was found at these poses may be told again.
    [[nodiscard]] bool is_known(const Pose& X_WO, const Pose& X_WT) const noexcept;
    void look(const Pose& X_WO, const Pose& X_OT) noexcept;

    // With a budget.
    [[nodiscard]] bool has_budget() const noexcept { return settings_.budget_us > 0.0; }
    [[nodiscard]] bool shares_time() const noexcept {
        return step_time_ != nullptr && step_time_->has_end();
    }
    void begin_look() noexcept;
    void end_look() noexcept;
    void begin_holding() noexcept;
    void hold_last(const Pose& X_WO) noexcept;
    // What the looks of a step have in common, from the first on in which not all fits.
    struct Choice {
        bool is_made = false;
        bool is_listed = false;  // which units; else all that may touch
        std::size_t thinning = 0;
        double missed_points = 0.0;
        double moved_m = 0.0, moved_m2 = 0.0;
    };
    void choose(std::size_t thinning, bool is_listed, const Nodes& units) noexcept;
    void revisit(const FieldPlace& place, const Pose& X_OT) noexcept;
    // The sweep's part of the step's time.
    void count_sweep(std::int64_t n_groups_before) noexcept;
    [[nodiscard]] bool has_time_to_sweep() const noexcept {
        return step_time_ == nullptr || step_time_->has_time_for(1.0);
    }
    void step_within_budget(const FieldPlace& place, const Pose& X_OT) noexcept;
    [[nodiscard]] double elapsed_us() const noexcept;
    // Until the step, or its part, must end.
    [[nodiscard]] double find_left_us() const noexcept;
    // Time since `before_us`; where it was taken by something else, it counts no longer.
    double find_lap_us(double before_us, double expected_us) noexcept;
    // What one of `n` things costs, from what they took.
    void learn(double& cost_us, double took_us, std::size_t n) const noexcept;
    void learn_reserve() noexcept;
    // Leaves that fit in a share of the time that is left.
    [[nodiscard]] std::size_t find_room(double share) const noexcept;
    // As far down as there is time; the level of the nodes found.
    std::size_t search_in_time(const FieldPlace& place) noexcept;
    // Of leaves as many as there is time for; how many.
    std::size_t take_in_time(std::size_t thinning, std::span<const std::int32_t> leaves,
                             const FieldPlace& place, const Pose& X_OT) noexcept;
    // All nodes, which are leaves.
    void take_leaves(const FieldPlace& place, const Pose& X_OT) noexcept;
    void forget_sums() noexcept;
    // What closer looks may fail to replace.
    struct FirstLook {
        ContactSums sums;
        ContactSpread spread;
        float deepest_steps = 0.0F;
        std::size_t n_touched = 0;
    };
    // Until when the leaves of a thinning are free, by their own points.
    [[nodiscard]] std::vector<float>& free_until(std::size_t thinning) noexcept {
        return thinning == 0 ? levels_.front().free_until : thinned_until_[thinning - 1];
    }
    void list_units(std::size_t level, std::size_t thinning) noexcept;
    float rank_units(std::size_t thinning) noexcept;
    void choose_units(std::size_t room) noexcept;
    void see_units(std::size_t thinning, const FieldPlace& place) noexcept;
    struct Finer {
        std::size_t thinning, n_wanted;
    };
    [[nodiscard]] Finer choose_finer(std::size_t thinning) noexcept;
    void list_parts(std::size_t thinning, const Finer& finer) noexcept;
    void leave_out_others(std::size_t level) noexcept;
    void leave_out_all(std::size_t level) noexcept;
    bool take_parts(std::size_t thinning, const FieldPlace& place, const Pose& X_OT) noexcept;
    // At parts of the units, as closely as there is time for; whether at each point of them.
    bool look_closer(std::size_t thinning, const FieldPlace& place, const Pose& X_OT) noexcept;
    // Whether enough of the samples touch to stand for all.
    bool take_samples(std::size_t level, const FieldPlace& place, const Pose& X_OT) noexcept;
    // Keeps as many of the nodes as there is room for, those that matter most.
    void choose_deepest(std::size_t level, std::size_t room) noexcept;
    void take_deepest(std::size_t level, const FieldPlace& place, const Pose& X_OT) noexcept;
    // Nodes whose points touched in the last step first, then those that reach farthest for their size; to `ranks_`.
    void rank_nodes(std::size_t level) noexcept;
    // How deep any point of a node may be that may be so deep by slack and motion.
    [[nodiscard]] double bound_depth_m(std::size_t level, std::size_t node,
                                       float depth_voxels) const noexcept;
    void leave_out(std::size_t level, std::size_t i) noexcept;
    // Leaves that touch for one whose derivatives fit in the time that is left.
    [[nodiscard]] std::size_t find_slopes_stride() const noexcept;

    // Leaves that cost what one's derivatives do.
    [[nodiscard]] std::int64_t slopes_leaves() const noexcept {
        return settings_.along == ForceAlong::slopes ? 4 : 16;
    }

    Field field_;
    Shell shell_;
    FieldSamplingSettings settings_;
    SlackBounds bounds_;
    SlopeBoxes slope_boxes_;
    double deepest_voxels_;  // of all the object's bricks
    const FieldKernels* kernels_;
    std::vector<Level> levels_;
    Nodes nodes_;
    std::vector<float> depths_;  // how deep they may be, slack's voxels
    std::vector<float> ranks_;
    // With a budget.
    Nodes leaves_;              // of a thinning, looked at first
    Nodes parts_, more_parts_;  // what they stand for
    SeenSamples seen_samples_;
    std::vector<std::vector<float>> thinned_until_;  // of each thinning but the first, as a level's
    Nodes last_touched_;
    double leaf_us_, group_us_, slopes_us_;  // learned
    double reserve_us_ = 0.0;                // likewise, before the end
    double share_ = 1.0;                     // of the time, until what runs must end
    double look_us_ = 0.0;                   // of this look
    double held_us_ = 0.0;                   // of it, for what was chosen before
    StepTime* step_time_ = nullptr;
    int n_near_ = 1;
    Choice choice_;
    Nodes chosen_;
    Nodes touched_;  // leaves of a thinning that were taken and touch
    double clock_voxels_ = 0.0;
    float now_ = 0.0F;  // the clock, rounded up
    // Where a leaf was looked at last, and how F falls round there.
    struct Seen {
        std::array<float, 3> middle{};  // of its ball, voxels of the field
        float least_voxels = -1.0F;     // F; below 0: not seen
        float turned_rad = 0.0F;
        float radius_voxels = 0.0F;
        SlopeBox slopes;
    };
    std::vector<Seen> seen_;
    double turned_rad_ = 0.0;  // all turns so far
    Pose last_OT_;
    bool has_last_ = false;
    // While a step runs.
    ContactLanes lanes_;
    std::size_t n_in_lanes_ = 0;
    ContactSums sums_;
    ContactSpread spread_;
    float deepest_steps_ = 0.0F;
    double began_s_ = 0.0;
    double left_out_m_ = 0.0;                // sum of n D
    double missed_points_ = 0.0;             // by samples that said where to look
    double moved_m_ = 0.0, moved_m2_ = 0.0;  // by closer looks, force and torque over the stiffness
    bool was_cut_short_ = false;
    bool held_ = false,
         held_before_ = false;  // the last look's force, in this step, in the one before
    FieldTouch touch_;
    // What was asked last, and found.
    Pose known_WO_, known_WT_;
    FieldTouch known_;
    bool is_known_ = false;
    bool is_known_in_step_ = false;
    Matrix6* slopes_O_ = nullptr;  // where derivatives are asked for; over the stiffness
};

}  // namespace fulcrum
