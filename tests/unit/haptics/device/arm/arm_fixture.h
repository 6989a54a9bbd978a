// Small arms with closed forms, and postures drawn from a seed.
#pragma once

#include "haptics/device/arm/arm_dynamics.h"
#include "haptics/device/arm/arm_motion.h"
#include "haptics/device/arm/barrett_wam.h"

#include <algorithm>
#include <initializer_list>
#include <random>

namespace fulcrum::arm_test {

inline constexpr double kGravity = 9.81;

/// A point mass on a rod of length `length_m` that swings about a level axis: the joint's +Z is the base's +Z, and weight
/// pulls along the base's +X, so that angle 0 hangs.
inline ArmModel make_pendulum(double mass_kg, double length_m) {
    ArmModel model;
    model.n = 1;
    model.links[0].a_m = length_m;
    model.links[0].mass_kg = mass_kg;
    model.links[0].damping_Nms_per_rad = 1.0e-9;
    model.links[0].low_rad = -50.0;
    model.links[0].high_rad = 50.0;
    model.transmission = JointMatrix::Identity(1, 1);
    model.gravity_B = Vector3(kGravity, 0.0, 0.0);
    return model;
}

/// The WAM without any friction, and without stops that a swing would meet.
inline ArmModel make_free_wam() {
    ArmModel wam = make_barrett_wam();
    for (ArmLink& link : wam.links) {
        link.dry_friction_Nm = 0.0;
        link.damping_Nms_per_rad = 1.0e-9;
        link.low_rad = -100.0;
        link.high_rad = 100.0;
    }
    return wam;
}

inline JointVector make_joints(std::initializer_list<double> values) {
    JointVector joints(static_cast<Index>(values.size()));
    std::ranges::copy(values, &joints.coeffRef(0));
    return joints;
}

inline JointVector draw(std::mt19937& random, int n, double most) {
    std::uniform_real_distribution<double> any(-most, most);
    JointVector drawn(n);
    for (int i = 0; i < n; ++i) {
        drawn(i) = any(random);
    }
    return drawn;
}
inline Vector3 draw_vector(std::mt19937& random, double most) {
    return Vector3(draw(random, 3, most).data());
}

inline ArmPosture posture_of(const ArmModel& model, const JointVector& q) {
    ArmPosture posture;
    compute_posture(model, q, posture);
    return posture;
}

/// Everything that dynamics need at a posture.
struct Place {
    Place(const ArmModel& model, const JointVector& q, const HeldMass& held = {})
        : rotors(compute_rotor_inertia(model)) {
        compute_posture(model, q, posture);
        compute_bodies(model, posture, held, bodies);
    }
    [[nodiscard]] JointMatrix inertia() const {
        return compute_joint_inertia(posture, bodies, rotors);
    }

    ArmPosture posture;
    ArmBodies bodies;
    JointMatrix rotors;
};

inline ArmState at_rest(const JointVector& q) {
    ArmState state;
    state.angle_rad = q;
    state.speed_rad_per_s = JointVector::Zero(q.size());
    state.holds.fill(JointHold::stuck);
    return state;
}

}  // namespace fulcrum::arm_test
