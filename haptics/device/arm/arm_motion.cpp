#include "haptics/device/arm/arm_motion.h"

#include "haptics/math/length.h"
#include "haptics/math/rotation.h"

#include <algorithm>

namespace fulcrum {
namespace {

// Of a spring whose force has a bound: the force, and the stiffness that is left of it.
struct BoundedSpring {
    Vector3 force;
    double stiffness;
};

BoundedSpring pull(const Vector3& stretch, double stiffness, double strongest) noexcept {
    const Vector3 force = stiffness * stretch;
    const double length = compute_length(force);
    if (length <= strongest) {
        return {force, stiffness};
    }
    return {force * (strongest / length), 0.0};
}

Vector3 compute_turn(const Pose& handle, const Pose& target) noexcept {
    return compute_log(handle.orientation * target.orientation.conjugate());
}

}  // namespace

ArmMotion::ArmMotion(const ArmModel& model)
    : model_(model), twists_(compute_twists(model)), rotors_(compute_rotor_inertia(model)) {
    const auto zero = [&] { return JointVector(JointVector::Zero(model.n)); };
    push_Nm_ = zero();
    problem_ = {JointMatrix::Zero(model.n, model.n), zero(), zero(), zero(), zero()};
}

HeldMass ArmMotion::held() const noexcept {
    return {grip_.push.mass_kg, grip_.inertia_kg_m2};
}

// The hand's wrench at the middle of the step were the velocity to stay, and what its springs and dampers add to the matrix.
void ArmMotion::add_grip(const GripTarget& target, const JointVector& v, double dt_s) noexcept {
    const HandleJacobian& jacobian = posture_.jacobian_B;
    const Vector6 motion = compute_motion_B(posture_, v);
    const BoundedSpring push = pull(target.pose_B.position - posture_.handle_B.position,
                                    grip_.push.stiffness_N_per_m, grip_.strongest_N);
    const BoundedSpring turn = pull(-compute_turn(posture_.handle_B, target.pose_B),
                                    grip_.turn_stiffness_Nm_per_rad, grip_.strongest_Nm);
    Vector6 wrench;
    wrench << push.force + grip_.push.damping_Ns_per_m * (target.velocity_B - motion.head<3>()),
        turn.force - grip_.turn_damping_Nms_per_rad * motion.tail<3>();
    const double linear = 0.5 * dt_s * (grip_.push.damping_Ns_per_m + 0.5 * dt_s * push.stiffness);
    const double turning =
        0.5 * dt_s * (grip_.turn_damping_Nms_per_rad + 0.5 * dt_s * turn.stiffness);
    Vector6 weights;
    weights << linear, linear, linear, turning, turning, turning;
    for (int i = 0; i < model_.n; ++i) {
        push_Nm_(i) += jacobian.col(i).dot(wrench);
        const Vector6 weighted = weights.cwiseProduct(jacobian.col(i));
        problem_.inertia.coeffRef(i, i) += weighted.dot(jacobian.col(i));
        for (int j = 0; j < i; ++j) {
            const double coupled = weighted.dot(jacobian.col(j));
            problem_.inertia.coeffRef(i, j) += coupled;
            problem_.inertia.coeffRef(j, i) += coupled;
        }
    }
}

StickSlipCount ArmMotion::step(const JointVector& torque_Nm, const GripTarget& target, double dt_s,
                               ArmState& state) noexcept {
    const JointVector& v = state.speed_rad_per_s;
    // Half a step on: bodies, weight, hand.
    const JointVector halfway = state.angle_rad + 0.5 * dt_s * v;
    compute_posture(model_, twists_, halfway, posture_);
    compute_bodies(model_, posture_, held(), bodies_);
    problem_.inertia = compute_joint_inertia(posture_, bodies_, rotors_);
    push_Nm_ = torque_Nm - compute_weight_torque(model_, posture_);
    add_grip(target, v, dt_s);
    // Friction and stops of each joint.
    for (int i = 0; i < model_.n; ++i) {
        const ArmLink& link = model_.links[static_cast<std::size_t>(i)];
        push_Nm_(i) -= link.damping_Nms_per_rad * v(i);
        problem_.inertia(i, i) += 0.5 * dt_s * link.damping_Nms_per_rad;
        problem_.dry(i) = dt_s * link.dry_friction_Nm;
        problem_.low(i) = std::min((link.low_rad - state.angle_rad(i)) / dt_s, 0.0);
        problem_.high(i) = std::max((link.high_rad - state.angle_rad(i)) / dt_s, 0.0);
    }
    // Once with the velocity as it is, to know its mean; once with the mean.
    const JointVector kept = multiply(problem_.inertia, v) + dt_s * push_Nm_;
    StickSlipCount count;
    JointVector after = v;
    for (int round = 0; round < 2; ++round) {
        const JointVector mean = 0.5 * (v + after);
        problem_.push = kept - dt_s * compute_motion_torque(posture_, bodies_, mean);
        const StickSlipCount one = solve_stick_slip(problem_, state.holds, after);
        count = {count.tries + one.tries, count.sweeps + one.sweeps};
    }
    for (int i = 0; i < model_.n; ++i) {
        const ArmLink& link = model_.links[static_cast<std::size_t>(i)];
        state.angle_rad(i) = std::clamp(state.angle_rad(i) + 0.5 * dt_s * (v(i) + after(i)),
                                        link.low_rad, link.high_rad);
    }
    state.speed_rad_per_s = after;
    return count;
}

double ArmMotion::compute_energy_J(const ArmState& state) const noexcept {
    ArmPosture posture;
    ArmBodies bodies;
    compute_posture(model_, state.angle_rad, posture);
    compute_bodies(model_, posture, held(), bodies);
    const JointMatrix inertia = compute_joint_inertia(posture, bodies, rotors_);
    const JointVector& v = state.speed_rad_per_s;
    double energy_J = 0.5 * v.dot(multiply(inertia, v));
    for (int i = 0; i < model_.n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const Vector3 centre_B =
            posture.origin_B[at + 1] + posture.turn_B[at + 1] * model_.links[at].centre_m;
        energy_J -= model_.links[at].mass_kg * model_.gravity_B.dot(centre_B);
    }
    return energy_J;
}

double ArmMotion::compute_grip_energy_J(const ArmState& state,
                                        const GripTarget& target) const noexcept {
    ArmPosture posture;
    compute_posture(model_, state.angle_rad, posture);
    return 0.5 * grip_.push.stiffness_N_per_m *
               (target.pose_B.position - posture.handle_B.position).squaredNorm() +
           0.5 * grip_.turn_stiffness_Nm_per_rad *
               compute_turn(posture.handle_B, target.pose_B).squaredNorm();
}

}  // namespace fulcrum
