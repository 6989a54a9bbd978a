// A tool of points on a virtual coupling: the hand holds the handle, the tool stays outside the voxels, and the hand feels the
// coupling between both.
//
//   massive    M a = coupling + voxel sampling, a rigid body by any integrator (integrator.h)
//   massless   coupling + voxel sampling = 0, sought anew each step by Newton: (D - J) dx = F, D = 1e-3 of the coupling's
//              stiffness; no inertia is felt and nothing oscillates, but the force's jumps between voxels pass unsmoothed
// Both steps see the handle and the object where they are at the step's end. The coupling's springs are clamped at half a voxel:
// beyond, they would pull the tool through the layer that pushes, which is a voxel thick. Near the object the handle's motion is
// clamped with them, |f(d) d/|d| + b (v_H - v_O)| <= f(s/2), for the damper would pull it through as well; what brakes the tool's own
// motion is not. The massless tool has no dampers and no brakes: it has no motion of its own. In free space, where no point is near a
// voxel that pushes or brakes, the hand feels exactly nothing, whatever the coupling's stretch: what a tool's inertia would be
// felt as there is left out, as McNeely does.
//
// Thread: the haptic loop. Cost: that of voxel sampling, once an explicit step and once an iteration of the implicit ones, and
// about 1 us; no allocation.
// Source: W. McNeely, K. Puterbaugh, J. Troy 1999, Six degree-of-freedom haptic rendering using voxel sampling, sections 5.1
// (coupling), 5.2 (clamp, no force in free space). M. Wan, W. McNeely 2003, Quasi-static approximation for 6 degrees-of-freedom
// haptic rendering, IEEE Visualization (massless).
#pragma once

#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/loads.h"
#include "haptics/tool/voxel_sampling.h"

namespace fulcrum {

enum class ToolMass : std::uint8_t { massive, massless };

/// Fixed at load.
struct VoxelToolSettings {
    ToolCouplingSettings coupling{};
    bool critically_damped = true;  ///< sets both dampers by the mass and the least moment
    /// Sets the coupling's clamps by the map: half a voxel, and the turn that moves the farthest point as far.
    bool clamped_at_half_voxel = true;
    /// Near the object the handle's motion is clamped with the springs; false leaves it to the dampers as they are.
    bool lead_clamped = true;
    bool silent_in_free_space = true;
    ToolMass mass = ToolMass::massive;
    IntegratorSettings integrator{.newton_iterations = 4};
    Inertia inertia{};  ///< of the massive tool; the brakes' too
    Vector3 grip_T{
        Vector3::Zero()};       ///< where the coupling holds it, metres from the centre of mass
    int static_iterations = 4;  ///< of the massless tool, a step; 1 to 100
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const VoxelToolSettings& settings);

/// What one step led to.
struct VoxelToolResult {
    Wrench felt_W{};         ///< on the hand, N and Nm about the grip
    VoxelContact contact{};  ///< at the tool's new pose
    StepResult
        step{};  ///< of the massive tool; where it could not be made the tool stands still where it was
};

class VoxelTool {
  public:
    /// Refuses what `validate` refuses, and what VoxelSampling::build does.
    [[nodiscard]] static Expected<VoxelTool> build(VoxelSamplingPlan sampling,
                                                   const VoxelToolSettings& settings);

    /// Of the tool's centre of mass, along its principal axes.
    [[nodiscard]] const RigidState& state() const noexcept { return state_; }
    [[nodiscard]] const VoxelSampling& sampling() const noexcept { return sampling_; }
    /// As it is after `critically_damped` and `clamped_at_half_voxel`.
    [[nodiscard]] const ToolCouplingSettings& coupling() const noexcept { return coupling_; }

    /// Puts the tool where the handle holds it, at rest.
    void place(const Pose& handle_W) noexcept;
    /// One step of `dt_s` that ends at `now_s`, where the handle and the object are as given. A handle or an object that is no
    /// number leaves the tool as it is, and nothing is felt.
    [[nodiscard]] VoxelToolResult step(const MovingFrame& handle, const MovingFrame& object,
                                       double now_s, double dt_s) noexcept;

  private:
    VoxelTool(VoxelSampling sampling, const VoxelToolSettings& settings) noexcept;
    // The handle with no more velocity than spring and damper together may use.
    [[nodiscard]] MovingFrame limit_lead(const MovingFrame& handle,
                                         const MovingFrame& object) const noexcept;
    [[nodiscard]] StepResult move(const ToolCouplingLoad& coupling, const VoxelSamplingLoad& voxels,
                                  double now_s, double dt_s) noexcept;
    void settle(const ToolCouplingLoad& coupling, const VoxelSamplingLoad& voxels,
                double now_s) noexcept;

    VoxelSampling sampling_;
    VoxelToolSettings settings_;
    ToolCouplingSettings coupling_;
    RigidState state_{};
    bool is_near_ = false;  // something was, at the end of the last step
};

}  // namespace fulcrum
