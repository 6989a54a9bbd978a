#include "haptics/tool/voxel_tool.h"

#include <Eigen/LU>
#include <algorithm>

namespace fulcrum {

void VoxelTool::place(const Pose& handle_W) noexcept {
    state_ = {};
    state_.pose_W.orientation = handle_W.orientation;
    state_.pose_W.position = handle_W.position - handle_W.orientation * settings_.grip_T;
}

VoxelToolResult VoxelTool::step(const MovingFrame& handle, const MovingFrame& object, double now_s,
                                double dt_s) noexcept {
    VoxelToolResult result;
    if (!is_finite(handle.pose_W) || !handle.velocity_W.linear.allFinite() ||
        !handle.velocity_W.angular.allFinite()) {
        result.step.status = StepStatus::not_finite;
        return result;
    }
    // What acts on the tool.
    ToolCouplingLoad coupling(coupling_, settings_.grip_T);
    coupling.set_handle(handle, now_s);
    VoxelSamplingLoad voxels(sampling_);
    voxels.set_object(object, now_s);
    // Where that moves it.
    if (settings_.mass == ToolMass::massive) {
        result.step = move(coupling, voxels, now_s, dt_s);
    } else {
        settle(coupling, voxels, now_s);
    }
    // What the hand feels of it.
    result.contact = voxels.compute_contact(state_, now_s);
    const bool is_free = result.contact.deepest() == VoxelClass::free;
    if (!(is_free && settings_.silent_in_free_space)) {
        result.felt_W = coupling.compute_felt_wrench(state_, now_s);
    }
    return result;
}

StepResult VoxelTool::move(const ToolCouplingLoad& coupling, const VoxelSamplingLoad& voxels,
                           double now_s, double dt_s) noexcept {
    const Loads loads(coupling, voxels);
    const StepResult result =
        step_rigid_body(settings_.integrator, settings_.inertia, loads, now_s - dt_s, dt_s, state_);
    if (!result.moved()) {
        state_.velocity_W = {};
    }
    return result;
}

// Each step of Newton is cut to half a voxel at the grip's arm, for beyond it the voxels are others.
void VoxelTool::settle(const ToolCouplingLoad& coupling, const VoxelSamplingLoad& voxels,
                       double now_s) noexcept {
    constexpr double kSlack = 1.0e-3;  // of the coupling's stiffness: keeps the matrix regular
    const double most_m = 0.5 * sampling_.frame().voxel_m;
    Vector6 slack;
    slack << Vector3::Constant(kSlack * coupling_.shift.stiffness_N_per_m),
        Vector3::Constant(kSlack * coupling_.turn.stiffness_Nm_per_rad);
    state_.velocity_W = {};
    for (int i = 0; i < settings_.static_iterations; ++i) {
        Wrench wrench;
        WrenchJacobian jacobian;
        coupling.add_linearised_wrench(state_, now_s, wrench, jacobian);
        voxels.add_linearised_wrench(state_, now_s, wrench, jacobian);
        Vector6 force;
        force << wrench.force, wrench.torque;
        Matrix6 matrix = -jacobian.pose;
        matrix.diagonal() += slack;
        const Vector6 change = matrix.partialPivLu().solve(force);
        if (!change.allFinite()) {
            return;
        }
        const double way_m =
            change.head<3>().norm() + sampling_.reach_m() * change.tail<3>().norm();
        const Vector6 cut = std::min(1.0, most_m / std::max(way_m, 1.0e-300)) * change;
        state_.pose_W.position += cut.head<3>();
        state_.pose_W.orientation = compute_exp(cut.tail<3>()) * state_.pose_W.orientation;
        state_.pose_W.orientation.normalize();
    }
}

}  // namespace fulcrum
