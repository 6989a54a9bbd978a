#include "haptics/device/arm/arm_control.h"

#include "haptics/device/arm/cholesky.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
// Beside J M^-1 J^T, which is 0.1 and more where the handle can move: far above its rounding, far below what is felt.
constexpr double kLeastMobility_per_kg = 1.0e-6;

}  // namespace

ArmControl::ArmControl(const ArmModel& model, const ArmControlSettings& settings)
    : model_(model),
      settings_(settings),
      rotors_(compute_rotor_inertia(model)),
      motor_per_joint_(compute_joint_per_motor(model).transpose()) {}

double ArmControl::compute_share(const JointVector& given, const JointVector& more) const noexcept {
    double share = 1.0;
    for (int k = 0; k < model_.n; ++k) {
        const double most = model_.motors[static_cast<std::size_t>(k)].max_torque_Nm;
        // How far the motor still is from the bound that `more` drives it to.
        const double room = std::max(most - (more(k) < 0.0 ? -given(k) : given(k)), 0.0);
        const double asked = std::abs(more(k));
        share = asked > room ? std::min(share, room / asked) : share;
    }
    return share;
}

JointVector ArmControl::compute_posture_torque(const JointVector& q,
                                               const JointVector& v) noexcept {
    const double omega = settings_.posture_per_s;
    const JointVector wanted = -omega * (omega * (q - settings_.home_rad) + 2.0 * v);
    compute_bodies(model_, posture_, HeldMass{}, bodies_);
    const JointMatrix inertia = compute_joint_inertia(posture_, bodies_, rotors_);
    const HandleJacobian& jacobian = posture_.jacobian_B;
    // J M^-1 M a_0 = J a_0: what the wanted acceleration would do to the handle is taken out again.
    using JacobianTransposed = Eigen::Matrix<double, Eigen::Dynamic, 6, 0, kMostJoints, 6>;
    JacobianTransposed response = jacobian.transpose();
    JointMatrix factor = inertia;
    factor_cholesky(factor);
    solve_cholesky(factor, response);
    Matrix6 mobility = jacobian.lazyProduct(response);
    mobility.diagonal().array() += kLeastMobility_per_kg;
    Vector6 felt = jacobian.lazyProduct(wanted);
    factor_cholesky(mobility);
    solve_cholesky(mobility, felt);
    JointVector torque = inertia.lazyProduct(wanted);
    torque -= jacobian.transpose().lazyProduct(felt);
    return torque;
}

ArmCommand ArmControl::step(const JointVector& q, const JointVector& v,
                            const Wrench& wrench_B) noexcept {
    compute_posture(model_, q, posture_);
    const JointVector weight = compute_weight_torque(model_, posture_);
    const JointVector wrench = posture_.jacobian_B.transpose().lazyProduct(stack(wrench_B));
    const JointVector posture = compute_posture_torque(q, v);
    // One after the other, each with the room that those before it leave.
    ArmCommand command;
    const JointVector nothing = JointVector::Zero(model_.n);
    const double weight_share = compute_share(nothing, compute_motor_torque(weight));
    command.torque_Nm = weight_share * weight;
    command.wrench_share =
        compute_share(compute_motor_torque(command.torque_Nm), compute_motor_torque(wrench));
    command.torque_Nm += command.wrench_share * wrench;
    command.posture_share =
        compute_share(compute_motor_torque(command.torque_Nm), compute_motor_torque(posture));
    command.torque_Nm += command.posture_share * posture;
    return command;
}

}  // namespace fulcrum
