// Featherstone's articulated-body algorithm in link coordinates with 6 x 6 matrices: another way to the same accelerations.
// Rotors count with their diagonal alone. Source: R. Featherstone 2008, Rigid body dynamics algorithms, table 7.1.
#pragma once

#include "haptics/device/arm/arm_model.h"
#include "haptics/math/rotation.h"

#include <cmath>

namespace fulcrum::arm_test {

using Spatial6 = Vector6;
using Spatial66 = Matrix6;

// Motion coordinates in frame A to those in frame B, which is turned by `turn_AB` and lies at `place_A`.
inline Spatial66 make_transform(const Matrix3& turn_AB, const Vector3& place_A) {
    Spatial66 x = Spatial66::Zero();
    x.topLeftCorner<3, 3>() = turn_AB.transpose();
    x.bottomRightCorner<3, 3>() = turn_AB.transpose();
    x.bottomLeftCorner<3, 3>() = -turn_AB.transpose() * compute_skew(place_A);
    return x;
}

inline Spatial66 make_motion_cross(const Spatial6& v) {
    Spatial66 m = Spatial66::Zero();
    m.topLeftCorner<3, 3>() = compute_skew(v.head<3>());
    m.bottomRightCorner<3, 3>() = m.topLeftCorner<3, 3>();
    m.bottomLeftCorner<3, 3>() = compute_skew(v.tail<3>());
    return m;
}

inline JointVector run_articulated_body(const ArmModel& model, const JointVector& q,
                                        const JointVector& v, const JointVector& torque) {
    const int n = model.n;
    std::array<Spatial66, kMostJoints> x, articulated;
    std::array<Spatial6, kMostJoints> s, velocity, bias, coupled, weighted;
    std::array<double, kMostJoints> inertia{}, left{};
    const JointMatrix rotors = compute_rotor_inertia(model);
    Spatial6 before = Spatial6::Zero();
    for (int k = 0; k < n; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const ArmLink& link = model.links[i];
        const Matrix3 about_z =
            AngleAxis(q(k) + link.theta_rad, Vector3::UnitZ()).toRotationMatrix();
        const Matrix3 about_x = AngleAxis(link.alpha_rad, Vector3::UnitX()).toRotationMatrix();
        const Vector3 place = about_z * Vector3(link.a_m, 0.0, 0.0) + Vector3(0.0, 0.0, link.d_m);
        x[i] = make_transform(about_z * about_x, place);
        Spatial6 axis = Spatial6::Zero();
        axis(2) = 1.0;
        s[i] = x[i] * axis;
        velocity[i] = x[i] * before + s[i] * v(k);
        coupled[i] = make_motion_cross(velocity[i]) * s[i] * v(k);
        const Matrix3 c = compute_skew(link.centre_m);
        Spatial66 body = Spatial66::Zero();
        body.topLeftCorner<3, 3>() = link.inertia_kg_m2 + link.mass_kg * c * c.transpose();
        body.topRightCorner<3, 3>() = link.mass_kg * c;
        body.bottomLeftCorner<3, 3>() = link.mass_kg * c.transpose();
        body.bottomRightCorner<3, 3>() = link.mass_kg * Matrix3::Identity();
        articulated[i] = body;
        bias[i] = -make_motion_cross(velocity[i]).transpose() * body * velocity[i];
        before = velocity[i];
    }
    for (int k = n - 1; k >= 0; --k) {
        const auto i = static_cast<std::size_t>(k);
        weighted[i] = articulated[i] * s[i];
        inertia[i] = s[i].dot(weighted[i]) + rotors(k, k);
        left[i] = torque(k) - s[i].dot(bias[i]);
        if (k > 0) {
            const Spatial66 seen =
                articulated[i] - weighted[i] * weighted[i].transpose() / inertia[i];
            const Spatial6 force = bias[i] + seen * coupled[i] + weighted[i] * left[i] / inertia[i];
            articulated[i - 1] += x[i].transpose() * seen * x[i];
            bias[i - 1] += x[i].transpose() * force;
        }
    }
    JointVector a(n);
    Spatial6 acceleration;
    acceleration << Vector3::Zero(), -model.gravity_B;
    for (int k = 0; k < n; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const Spatial6 carried = x[i] * acceleration + coupled[i];
        a(k) = (left[i] - weighted[i].dot(carried)) / inertia[i];
        acceleration = carried + s[i] * a(k);
    }
    return a;
}

}  // namespace fulcrum::arm_test
