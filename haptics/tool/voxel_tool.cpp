#include "haptics/tool/voxel_tool.h"

#include "haptics/math/length.h"

#include <Eigen/LU>
#include <algorithm>

namespace fulcrum {
namespace {

bool is_number(const MovingFrame& frame) noexcept {
    return is_finite(frame.pose_W) && frame.velocity_W.linear.allFinite() &&
           frame.velocity_W.angular.allFinite();
}

// The velocity with which pull + damping velocity is at most `most`, along it; `most` 0: any.
Vector3 limit_velocity(const Vector3& velocity, const Vector3& pull, double damping,
                       double most) noexcept {
    const Vector3 lead = pull + damping * velocity;
    const double size = compute_length(lead);
    return most > 0.0 && damping > 0.0 && size > most
               ? Vector3((lead * (most / size) - pull) / damping)
               : velocity;
}

}  // namespace

MovingFrame VoxelTool::limit_lead(const MovingFrame& handle,
                                  const MovingFrame& object) const noexcept {
    const Pose grip_W{state_.pose_W * settings_.grip_T, state_.pose_W.orientation};
    const Wrench pull = compute_tool_coupling(coupling_, {handle.pose_W, {}}, {grip_W, {}});
    // As the object sees it, so that it may move with the hand.
    const Vector3 arm_W = grip_W.position - object.pose_W.position;
    const Vector3 object_W = object.velocity_W.linear + object.velocity_W.angular.cross(arm_W);
    const Vector3& spin_W = object.velocity_W.angular;
    MovingFrame limited = handle;
    limited.velocity_W.linear =
        object_W + limit_velocity(handle.velocity_W.linear - object_W, pull.force,
                                  coupling_.shift.damping_Ns_per_m,
                                  coupling_.shift.stiffness_N_per_m * coupling_.clamp_m);
    limited.velocity_W.angular =
        spin_W + limit_velocity(handle.velocity_W.angular - spin_W, pull.torque,
                                coupling_.turn.damping_Nms_per_rad,
                                coupling_.turn.stiffness_Nm_per_rad * coupling_.clamp_rad);
    return limited;
}

void VoxelTool::place(const Pose& handle_W) noexcept {
    state_ = {};
    state_.pose_W.orientation = handle_W.orientation;
    state_.pose_W.position = handle_W.position - handle_W.orientation * settings_.grip_T;
    is_near_ = false;
}

VoxelToolResult VoxelTool::step(const MovingFrame& handle, const MovingFrame& object, double now_s,
                                double dt_s) noexcept {
    VoxelToolResult result;
    if (!is_number(handle) || !is_number(object)) {
        result.step.status = StepStatus::not_finite;
        return result;
    }
    // What acts on the tool.
    ToolCouplingLoad coupling(coupling_, settings_.grip_T);
    coupling.set_handle(is_near_ && settings_.lead_clamped ? limit_lead(handle, object) : handle,
                        now_s);
    sampling_.set_cycle(dt_s);
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
    is_near_ = !is_free;
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
