// Where a rigid body is and how it moves, what it is made of, and what follows from both.
//
// The state is (x, q, v, w): the centre of mass, a unit quaternion, linear and angular velocity, all in W. Integrators
// step the momenta P = m v and L = R I R^T w instead of the velocities: dL/dt = torque needs no gyroscopic term, and no
// torque leaves L as it is: to rounding, and in backward Euler to Newton's tolerance. Loads and constraints want
// velocities, so those are what is kept.
//
// Thread: any. Cost: some 30 multiplications each.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

/// What a step changes.
struct RigidState {
    Pose
        pose_W{};  ///< of the body's frame: its origin is the centre of mass, its axes are the principal ones
    Twist velocity_W{};  ///< m/s of the centre of mass, rad/s
};

/// Fixed at load. `validate` in integrator.h.
struct Inertia {
    double mass_kg = 0.01;  ///< 1e-6 to 1e6
    Vector3 moments_kg_m2{2.4e-6, 2.4e-6,
                          2.4e-6};  ///< principal, 1e-12 to 1e6, each at most the sum of the others
};

/// A ball of even density.
[[nodiscard]] inline Inertia make_ball_inertia(double mass_kg, double radius_m) noexcept {
    return {mass_kg, Vector3::Constant(0.4 * mass_kg * radius_m * radius_m)};
}
/// A box of even density with these edges.
[[nodiscard]] inline Inertia make_box_inertia(double mass_kg, const Vector3& edges_m) noexcept {
    const Vector3 squared = edges_m.cwiseAbs2();
    return {mass_kg, mass_kg / 12.0 * (Vector3::Constant(squared.sum()) - squared)};
}

/// R I R^T, kg m^2.
[[nodiscard]] inline Matrix3 compute_inertia_W(const Inertia& inertia,
                                               const Quaternion& orientation) noexcept {
    const Matrix3 R = orientation.toRotationMatrix();
    return R * inertia.moments_kg_m2.asDiagonal() * R.transpose();
}
/// L = R I R^T w, kg m^2/s about the centre of mass.
[[nodiscard]] inline Vector3 compute_angular_momentum_W(const Inertia& inertia,
                                                        const RigidState& state) noexcept {
    const Quaternion& q = state.pose_W.orientation;
    const Vector3 spin_B = q.conjugate() * state.velocity_W.angular;
    return q * Vector3(inertia.moments_kg_m2.cwiseProduct(spin_B));
}
/// w = R I^-1 R^T L, rad/s.
[[nodiscard]] inline Vector3 compute_spin_W(const Inertia& inertia, const Quaternion& orientation,
                                            const Vector3& angular_momentum_W) noexcept {
    const Vector3 momentum_B = orientation.conjugate() * angular_momentum_W;
    return orientation * Vector3(momentum_B.cwiseQuotient(inertia.moments_kg_m2));
}
/// (m v.v + w.L) / 2, joules.
[[nodiscard]] inline double compute_kinetic_energy_J(const Inertia& inertia,
                                                     const RigidState& state) noexcept {
    const double turning = state.velocity_W.angular.dot(compute_angular_momentum_W(inertia, state));
    return 0.5 * (inertia.mass_kg * state.velocity_W.linear.squaredNorm() + turning);
}

[[nodiscard]] inline bool is_finite(const RigidState& state) noexcept {
    return is_finite(state.pose_W) && state.velocity_W.linear.allFinite() &&
           state.velocity_W.angular.allFinite();
}

}  // namespace fulcrum
