#include "haptics/device/arm/arm_control.h"

#include "haptics/device/arm/cholesky.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

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

JointVector ArmControl::compute_posture_torque(const ArmPosture& posture, const JointVector& q,
                                               const JointVector& v) noexcept {
    const double omega = settings_.posture_per_s;
    const JointVector wanted = -omega * (omega * (q - settings_.home_rad) + 2.0 * v);
    compute_bodies(model_, posture, HeldMass{}, bodies_);
    const JointMatrix inertia = compute_joint_inertia(posture, bodies_, rotors_);
    const HandleJacobian& jacobian = posture.jacobian_B;
    // J M^-1 J^T by half of M's factor; J M^-1 M a_0 = J a_0: what the wanted acceleration would do to the handle is taken out again.
    JointMatrix factor = inertia;
    factor_cholesky(factor);
    HandleJacobian response = jacobian;
    solve_lower(factor, response);
    Matrix6 mobility = kLeastMobility_per_kg * Matrix6::Identity();
    Vector6 felt = Vector6::Zero();
    for (int i = 0; i < model_.n; ++i) {
        mobility += response.col(i) * response.col(i).transpose();
        felt += jacobian.col(i) * wanted(i);
    }
    factor_cholesky(mobility);
    solve_cholesky(mobility, felt);
    JointVector torque = multiply(inertia, wanted);
    for (int i = 0; i < model_.n; ++i) {
        torque(i) -= jacobian.col(i).dot(felt);
    }
    return torque;
}

ArmCommand ArmControl::step(const ArmPosture& posture, const JointVector& q, const JointVector& v,
                            const Wrench& wrench_B) noexcept {
    const JointVector weight = compute_weight_torque(model_, posture);
    const JointVector swing = compute_posture_torque(posture, q, v);
    const Vector6 wrench = stack(wrench_B);
    JointVector shown(model_.n);
    for (int i = 0; i < model_.n; ++i) {
        shown(i) = posture.jacobian_B.col(i).dot(wrench);
    }
    // One after the other, each with the room that those before it leave; at the joints, and at the motors.
    ArmCommand command{JointVector::Zero(model_.n), 1.0, 1.0};
    JointVector given = JointVector::Zero(model_.n);
    const auto give = [&](const JointVector& torque) {
        const JointVector more = compute_motor_torque(torque);
        const double share = compute_share(given, more);
        given += share * more;
        command.torque_Nm += share * torque;
        return share;
    };
    give(weight);
    command.wrench_share = give(shown);
    command.posture_share = give(swing);
    return command;
}

}  // namespace fulcrum
