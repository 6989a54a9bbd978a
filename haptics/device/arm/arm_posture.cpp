#include "haptics/device/arm/arm_posture.h"

#include <cmath>

namespace fulcrum {

ArmTwists compute_twists(const ArmModel& model) noexcept {
    ArmTwists twists;
    for (std::size_t i = 0; i < static_cast<std::size_t>(model.n); ++i) {
        twists[i] = {std::cos(model.links[i].alpha_rad), std::sin(model.links[i].alpha_rad)};
    }
    return twists;
}

void compute_posture(const ArmModel& model, const JointVector& q, ArmPosture& posture) noexcept {
    compute_posture(model, compute_twists(model), q, posture);
}

void compute_posture(const ArmModel& model, const ArmTwists& twists, const JointVector& q,
                     ArmPosture& posture) noexcept {
    posture.n = model.n;
    posture.turn_B[0].setIdentity();
    posture.origin_B[0].setZero();
    for (int i = 0; i < model.n; ++i) {
        const auto before = static_cast<std::size_t>(i);
        const ArmLink& link = model.links[before];
        const double angle = q(i) + link.theta_rad;
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const auto [ca, sa] = twists[before];
        Matrix3 turn;
        turn << c, -s * ca, s * sa, s, c * ca, -c * sa, 0.0, sa, ca;
        const Matrix3& turn_B = posture.turn_B[before];
        posture.origin_B[before + 1] =
            posture.origin_B[before] + turn_B * Vector3(link.a_m * c, link.a_m * s, link.d_m);
        posture.turn_B[before + 1] = turn_B * turn;
    }
    const auto last = static_cast<std::size_t>(model.n);
    posture.handle_B.position =
        posture.origin_B[last] + posture.turn_B[last] * model.handle.position;
    posture.handle_B.orientation = Quaternion(posture.turn_B[last]) * model.handle.orientation;
    posture.handle_B.orientation.normalize();
    posture.jacobian_B.setZero();
    for (int i = 0; i < model.n; ++i) {
        const Vector3 axis_B = posture.axis_B(i);
        posture.jacobian_B.col(i) << axis_B.cross(posture.handle_B.position -
                                                  posture.origin_B[static_cast<std::size_t>(i)]),
            axis_B;
    }
}

Vector6 compute_motion_B(const ArmPosture& posture, const JointVector& v) noexcept {
    Vector6 motion = Vector6::Zero();
    for (Index i = 0; i < v.size(); ++i) {
        motion += posture.jacobian_B.col(i) * v(i);
    }
    return motion;
}

}  // namespace fulcrum
