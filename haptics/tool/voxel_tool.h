// A tool of points on a virtual coupling: the hand holds the handle, the tool stays outside the objects, and the hand feels the
// coupling between both. Its points are sampled in voxels (voxel_sampling.h) or in distance fields (field_load.h).
//
//   massive    M a = coupling + sampling, a rigid body by any integrator (integrator.h)
//   massless   coupling + sampling = 0, sought anew each step by Newton: (D - J) dx = F, D = 1e-3 of the coupling's
//              stiffness; no inertia is felt and nothing oscillates, but the force's jumps between voxels pass unsmoothed
// Both steps see the handle and the object where they are at the step's end. The coupling's springs are clamped at half a voxel:
// beyond, they would pull the tool through the layer that pushes, which is a voxel thick. Near the object the handle's motion is
// clamped with them, |f(d) d/|d| + b (v_H - v_O)| <= f(s/2), for the damper would pull it through as well; what brakes the tool's own
// motion is not. What the hand feels is clamped likewise, |felt| <= f(s/2): a fast wall that carries the tool along would give it that
// damper's force. The massless tool has no dampers and no brakes: it has no motion of its own. In free space, where no point is near a
// voxel that pushes or brakes, the hand feels exactly nothing, whatever the coupling's stretch: what a tool's inertia would be
// felt as there is left out, as McNeely does.
//
// A step's motion is swept: however fast tool or object, in a field no point passes more than a voxel into an object in one step
// (field_load.h); among voxels, from a voxel a step to 16, it is looked on the way for what would penetrate (voxel_sampling.h). So no
// wall of two voxels is passed at once.
//
// Several objects, each with its map and its own motion, add up. Each of n that brake at once brakes by an n-th of what it would
// alone, for together they must not take more motion than there is; n is that of the very pose and motion that brakes.
//
// A budget of time is one step's (step_time.h): the solver's looks share it, and Newton's method ends with the best it has found when it
// is over. What was accepted for it is told: how far the force may be off, and whether the method came to its end.
//
// Thread: the haptic loop. Cost: that of the sampling, once an explicit step and once an iteration of the implicit ones, and
// about 1 us; no allocation.
// Source: W. McNeely, K. Puterbaugh, J. Troy 1999, Six degree-of-freedom haptic rendering using voxel sampling, sections 5.1
// (coupling), 5.2 (clamp, no force in free space). M. Wan, W. McNeely 2003, Quasi-static approximation for 6 degrees-of-freedom
// haptic rendering, IEEE Visualization (massless).
#pragma once

#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/loads.h"
#include "haptics/tool/field_sampling/field_load.h"
#include "haptics/tool/tool_solver.h"
#include "haptics/tool/voxel_sampling/voxel_sampling.h"

#include <vector>

namespace fulcrum {

enum class ToolMass : std::uint8_t { massive, massless };

/// Fixed at load.
struct VoxelToolSettings {
    ToolCouplingSettings coupling{};
    bool critically_damped =
        true;  ///< sets both dampers: by the mass, and by the moments about the principal axes
    /// Sets the coupling's clamps by the map: half a voxel, and the turn that moves the farthest point as far.
    bool clamped_at_half_voxel = true;
    /// Near the object the handle's motion is clamped with the springs, and what is felt; false leaves both to the dampers as they
    /// are.
    bool lead_clamped = true;
    bool silent_in_free_space = true;
    bool swept = true;  ///< the tool stops where a step's motion would take it into an object
    ToolMass mass = ToolMass::massive;
    IntegratorSettings integrator{.newton_iterations = 12};
    Inertia inertia{};  ///< of the massive tool; the brakes' too
    Vector3 grip_T{
        Vector3::Zero()};  ///< where the coupling holds it, metres from the centre of mass
    Quaternion handle_turn{
        Quaternion::Identity()};  ///< q_HT, unit: how the tool lies in the handle
    int static_iterations = 4;    ///< of the massless tool, a step; 1 to 100
    double budget_us =
        0.0;  ///< of a step, for looking at points; 0: as long as it takes; else 20 to 1e5
    BudgetClock clock = BudgetClock::measured;
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const VoxelToolSettings& settings);

/// What one step led to.
struct VoxelToolResult : ToolFelt {
    VoxelContact contact{};  ///< at the tool's new pose, of all objects together
    /// Where it could not be made the tool stands still where it was; a massless one is done, or out of time.
    StepResult step{};
};

/// `Sampling` is VoxelSampling or FieldSampling, `Plan` what it is built from.
template <class Sampling, class Plan>
class SampledTool final : public ToolSolver {
  public:
    /// Refuses what `validate` refuses, and what the sampling's build does.
    [[nodiscard]] static Expected<SampledTool> build(Plan sampling,
                                                     const VoxelToolSettings& settings);
    /// The same for several objects, at least one: the finest voxels set the clamps.
    [[nodiscard]] static Expected<SampledTool> build(std::vector<Plan> samplings,
                                                     const VoxelToolSettings& settings);
    SampledTool(SampledTool&&) noexcept = default;
    SampledTool& operator=(SampledTool&&) noexcept = default;
    ~SampledTool() override;

    /// Of the tool's centre of mass, along its principal axes.
    [[nodiscard]] const RigidState& state() const noexcept { return state_; }
    /// Of the first object.
    [[nodiscard]] const Sampling& sampling() const noexcept { return samplings_.front(); }
    /// As it is after `critically_damped` and `clamped_at_half_voxel`.
    [[nodiscard]] const ToolCouplingSettings& coupling() const noexcept { return coupling_; }

    void place(const Pose& handle_W) noexcept override;
    [[nodiscard]] bool is_free(std::span<const MovingFrame> objects) const noexcept override;
    [[nodiscard]] ToolFelt move(const MovingFrame& handle, std::span<const MovingFrame> objects,
                                double now_s, double dt_s) noexcept override;
    /// The same with one object. A handle or an object that is no number leaves the tool as it is, and nothing is felt.
    [[nodiscard]] VoxelToolResult step(const MovingFrame& handle, const MovingFrame& object,
                                       double now_s, double dt_s) noexcept;

    [[nodiscard]] Pose grip_W() const noexcept override;
    [[nodiscard]] const Vector3& centre_W() const noexcept override {
        return state_.pose_W.position;
    }
    [[nodiscard]] std::span<const ToolTouch> touches() const noexcept override { return touches_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override;

  private:
    // The grip, along the tool's own axes.
    [[nodiscard]] Pose held_W() const noexcept;
    SampledTool(std::vector<Sampling> samplings, const VoxelToolSettings& settings);
    [[nodiscard]] VoxelToolResult run(MovingFrame handle, std::span<const MovingFrame> objects,
                                      double now_s, double dt_s) noexcept;
    // The objects are here now; brakes reckon with a step of that length.
    void set_objects(std::span<const MovingFrame> objects, double now_s, double dt_s) noexcept;
    // The handle with no more velocity than spring and damper together may use, as each near object sees it.
    [[nodiscard]] MovingFrame limit_lead(const MovingFrame& handle,
                                         std::span<const MovingFrame> objects) const noexcept;
    void limit_lead_to(const MovingFrame& object, const Wrench& pull,
                       MovingFrame& handle) const noexcept;
    [[nodiscard]] StepResult advance(const Load& coupling, const Load& points, double now_s,
                                     double dt_s) noexcept;
    // Whether it came to its end in time.
    bool settle(const Load& coupling, const Load& points, double now_s) noexcept;
    // Back from where the step led to what is touched on the way there.
    void stop_at_touch(const Pose& before_W, std::span<const MovingFrame> objects,
                       double dt_s) noexcept;
    [[nodiscard]] VoxelContact look(double now_s) noexcept;
    // What is asked of the samplings shares the time of a step that begins now, until `end_time`.
    void begin_time(int n_looks) const noexcept;
    void end_time() const noexcept;
    [[nodiscard]] ToolEffort tell_effort(const VoxelToolResult& result) const noexcept;

    std::vector<Sampling> samplings_;            // one an object
    std::vector<SamplingLoad<Sampling>> loads_;  // of the samplings, which stay where they are
    std::vector<ToolTouch> touches_;
    std::vector<Wrench> brakes_W_;    // of each object, were it alone
    std::vector<std::uint8_t> near_;  // something of the object was, at the end of the last step
    std::vector<double> depths_m_;    // of the deepest point in each object, likewise
    VoxelToolSettings settings_;
    ToolCouplingSettings coupling_;
    double least_voxel_m_ = 0.0;
    RigidState state_{};
    mutable StepTime time_;
};

using VoxelTool = SampledTool<VoxelSampling, VoxelSamplingPlan>;
using FieldTool = SampledTool<FieldSampling, FieldSamplingPlan>;

}  // namespace fulcrum
