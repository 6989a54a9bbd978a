#include "haptics/dynamics/loads.h"

#include <algorithm>

namespace fulcrum {
namespace {

// A body's point: its arm from the centre of mass, place and velocity in W.
struct BodyPoint {
    Vector3 arm;
    Vector3 position;
    Vector3 velocity;
};

BodyPoint locate(const RigidState& state, const Vector3& arm_W) noexcept {
    return {arm_W, state.pose_W.position + arm_W,
            state.velocity_W.linear + state.velocity_W.angular.cross(arm_W)};
}

NormalPush compute_push(const PlaneContact& contact, const BodyPoint& point) noexcept {
    const double depth_m = -contact.normal_W.dot(point.position - contact.plane_point_W);
    if (!(depth_m > 0.0)) {
        return {};
    }
    const double sinking_m_per_s = -contact.normal_W.dot(point.velocity - contact.plane_velocity_W);
    // s(d) = min(d / d_r, 1); its slope is 1/d_r on the ramp and 0 behind it.
    const bool on_ramp = depth_m < contact.damping_ramp_m;
    const double share = on_ramp ? depth_m / contact.damping_ramp_m : 1.0;
    const double share_slope_per_m = on_ramp ? 1.0 / contact.damping_ramp_m : 0.0;
    const double push_N =
        contact.stiffness_N_per_m * depth_m + contact.damping_Ns_per_m * share * sinking_m_per_s;
    if (!(push_N > 0.0)) {
        return {};
    }
    return {
        push_N,
        contact.stiffness_N_per_m + contact.damping_Ns_per_m * share_slope_per_m * sinking_m_per_s,
        contact.damping_Ns_per_m * share};
}

Vector3 compute_spring_force(const PointSpring& spring, const BodyPoint& point) noexcept {
    return -spring.stiffness_N_per_m * (point.position - spring.anchor_W) -
           spring.damping_Ns_per_m * point.velocity;
}

}  // namespace

void ConstantLoad::add_wrench(const RigidState& /*state*/, double /*time_s*/,
                              Wrench& wrench) const noexcept {
    wrench.force += wrench_W_.force;
    wrench.torque += wrench_W_.torque;
}

void ConstantLoad::add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                                         WrenchJacobian& /*jacobian*/) const noexcept {
    add_wrench(state, time_s, wrench);
}

void PointSpringLoad::add_wrench(const RigidState& state, double /*time_s*/,
                                 Wrench& wrench) const noexcept {
    const BodyPoint point = locate(state, state.pose_W.orientation * spring_.point_B);
    add_point_force(point.arm, compute_spring_force(spring_, point), wrench);
}

void PointSpringLoad::add_linearised_wrench(const RigidState& state, double /*time_s*/,
                                            Wrench& wrench,
                                            WrenchJacobian& jacobian) const noexcept {
    const BodyPoint point = locate(state, state.pose_W.orientation * spring_.point_B);
    const PointForce force{compute_spring_force(spring_, point),
                           -spring_.stiffness_N_per_m * Matrix3::Identity(),
                           -spring_.damping_Ns_per_m * Matrix3::Identity()};
    add_point_force(point.arm, state.velocity_W.angular, force, wrench, jacobian);
}

double compute_depth_m(const PlaneContact& contact, const Pose& pose_W) noexcept {
    return -contact.normal_W.dot(pose_W * contact.point_B - contact.plane_point_W);
}

double compute_push_N(const PlaneContact& contact, const RigidState& state) noexcept {
    return compute_push(contact, locate(state, state.pose_W.orientation * contact.point_B)).push_N;
}

void PlaneContactsLoad::add_wrench(const RigidState& state, double /*time_s*/,
                                   Wrench& wrench) const noexcept {
    const Matrix3 R = state.pose_W.orientation.toRotationMatrix();
    for (const PlaneContact& contact : contacts_) {
        const BodyPoint point = locate(state, R * contact.point_B);
        add_point_force(point.arm, compute_push(contact, point).push_N * contact.normal_W, wrench);
    }
}

void PlaneContactsLoad::add_linearised_wrench(const RigidState& state, double /*time_s*/,
                                              Wrench& wrench,
                                              WrenchJacobian& jacobian) const noexcept {
    const Matrix3 R = state.pose_W.orientation.toRotationMatrix();
    for (const PlaneContact& contact : contacts_) {
        const BodyPoint point = locate(state, R * contact.point_B);
        const NormalPush push = compute_push(contact, point);
        if (push.push_N > 0.0) {
            add_normal_push(point.arm, state.velocity_W.angular, contact.normal_W, push, wrench,
                            jacobian);
        }
    }
}

void ToolCouplingLoad::set_handle(const MovingFrame& handle, double time_s) noexcept {
    handle_ = handle;
    handle_time_s_ = time_s;
}

MovingFrame ToolCouplingLoad::compute_handle(double time_s) const noexcept {
    return move_evenly(handle_, time_s - handle_time_s_);
}

MovingFrame ToolCouplingLoad::compute_grip(const RigidState& state) const noexcept {
    const BodyPoint grip = locate(state, state.pose_W.orientation * grip_B_);
    return {{grip.position, state.pose_W.orientation}, {grip.velocity, state.velocity_W.angular}};
}

Wrench ToolCouplingLoad::compute_felt_wrench(const RigidState& state,
                                             double time_s) const noexcept {
    const Wrench on_tool =
        compute_tool_coupling(settings_, compute_handle(time_s), compute_grip(state));
    return {-on_tool.force, -on_tool.torque};
}

void ToolCouplingLoad::add_wrench(const RigidState& state, double time_s,
                                  Wrench& wrench) const noexcept {
    const MovingFrame grip = compute_grip(state);
    const Wrench coupling = compute_tool_coupling(settings_, compute_handle(time_s), grip);
    add_point_force(state.pose_W.orientation * grip_B_, coupling.force, wrench);
    wrench.torque += coupling.torque;
}

void ToolCouplingLoad::add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                                             WrenchJacobian& jacobian) const noexcept {
    const MovingFrame grip = compute_grip(state);
    const ToolCouplingWrench coupling =
        compute_linearised_tool_coupling(settings_, compute_handle(time_s), grip);
    add_point_force(state.pose_W.orientation * grip_B_, state.velocity_W.angular, coupling.shift,
                    wrench, jacobian);
    wrench.torque += coupling.torque;
    jacobian.pose.bottomRightCorner<3, 3>() += coupling.torque_by_turn;
    jacobian.velocity.bottomRightCorner<3, 3>() += coupling.torque_by_spin;
}

}  // namespace fulcrum
