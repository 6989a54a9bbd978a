// How a wrench on a rigid body changes with the body's pose and velocity, and what a force at one of its points adds.
//
//   pose       x <- x + dx,  q <- exp(dtheta) q: a left perturbation, so dtheta is a rotation vector in W about the
//              body's origin; v and w stay
//   velocity   v <- v + dv,  w <- w + dw, both in W; the pose stays
// Rows: force, torque about the origin. Columns: dx, dtheta or dv, dw. A force F(p, u) that depends on where a body's
// point p = x + r is and on how it moves, u = v + w x r, has with A = dF/dp, B = dF/du, [a] b = a x b:
//   dF = A (dx - [r] dtheta) + B (dv - [r] dw - [w][r] dtheta)
//   d(r x F) = r x dF + [F][r] dtheta
// Thread: any. Cost: about 100 multiplications.
// Source: M. Otaduy, M. Lin 2005, Stable and responsive six-degree-of-freedom haptic manipulation using implicit
// integration, World Haptics, sections 5.2 and 6.3, which differentiate by the quaternion's four numbers; here by the
// three of the rotation's tangent space.
#pragma once

#include "haptics/math/rotation.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

/// A wrench's derivatives; world frame, SI units, 6 x 6 each.
struct WrenchJacobian {
    Matrix6 pose{Matrix6::Zero()};      ///< by (dx, dtheta)
    Matrix6 velocity{Matrix6::Zero()};  ///< by (dv, dw)
};

/// A force at a point and how it depends on where the point is and how it moves; world frame.
struct PointForce {
    Vector3 force{Vector3::Zero()};        ///< newtons
    Matrix3 by_position{Matrix3::Zero()};  ///< N/m
    Matrix3 by_velocity{Matrix3::Zero()};  ///< Ns/m
};

/// Adds a force at the point `arm_W` from the origin to a wrench.
inline void add_point_force(const Vector3& arm_W, const Vector3& force_W, Wrench& wrench) noexcept {
    wrench.force += force_W;
    wrench.torque += arm_W.cross(force_W);
}

/// Adds to a wrench's derivatives by the pose those of a force at a point, whose arm stands as the matrix of its cross product:
/// by the point's place, and by the body's turning, which moves the point.
inline void add_point_slopes(const Matrix3& arm, const Vector3& force, const Matrix3& by_position,
                             const Matrix3& by_turn, Matrix6& by_pose) noexcept {
    by_pose.topLeftCorner<3, 3>() += by_position;
    by_pose.topRightCorner<3, 3>() += by_turn;
    by_pose.bottomLeftCorner<3, 3>() += arm * by_position;
    by_pose.bottomRightCorner<3, 3>() += arm * by_turn + compute_skew(force) * arm;
}

/// Adds a force at the point `arm_W` from the origin, of a body that turns at `spin_W`, to a wrench and its derivatives.
inline void add_point_force(const Vector3& arm_W, const Vector3& spin_W, const PointForce& point,
                            Wrench& wrench, WrenchJacobian& jacobian) noexcept {
    add_point_force(arm_W, point.force, wrench);
    const Matrix3 arm = compute_skew(arm_W);
    const Matrix3 by_turn = -(point.by_position + point.by_velocity * compute_skew(spin_W)) * arm;
    const Matrix3 by_spin = -point.by_velocity * arm;
    add_point_slopes(arm, point.force, point.by_position, by_turn, jacobian.pose);
    jacobian.velocity.topLeftCorner<3, 3>() += point.by_velocity;
    jacobian.velocity.topRightCorner<3, 3>() += by_spin;
    jacobian.velocity.bottomLeftCorner<3, 3>() += arm * point.by_velocity;
    jacobian.velocity.bottomRightCorner<3, 3>() += arm * by_spin;
}

/// A push along a normal that does not turn, and how it falls as its point goes along the normal.
struct NormalPush {
    double push_N = 0.0;
    double by_depth_N_per_m = 0.0;
    double by_sinking_Ns_per_m = 0.0;
};

/// As `add_point_force` of F = push n with A = -by_depth n n^T and B = -by_sinking n n^T, by the products of vectors
/// that this is: with g = (n, r x n), dF and d(r x F) are -g times by_depth g . (dx, dtheta) + by_sinking (g . (dv, dw) + r x (n x w) . dtheta).
inline void add_normal_push(const Vector3& arm_W, const Vector3& spin_W, const Vector3& normal_W,
                            const NormalPush& push, Wrench& wrench,
                            WrenchJacobian& jacobian) noexcept {
    const Vector3 turn = arm_W.cross(normal_W);
    wrench.force += push.push_N * normal_W;
    wrench.torque += push.push_N * turn;
    Vector6 along;
    along << normal_W, turn;
    Vector6 falls = push.by_depth_N_per_m * along;
    if (push.by_sinking_Ns_per_m != 0.0) {
        falls.tail<3>() += push.by_sinking_Ns_per_m * arm_W.cross(normal_W.cross(spin_W));
        jacobian.velocity -= (push.by_sinking_Ns_per_m * along) * along.transpose();
    }
    jacobian.pose -= along * falls.transpose();
    // [F] [r] = r F^T - (F . r) 1.
    const Vector3 force = push.push_N * normal_W;
    jacobian.pose.bottomRightCorner<3, 3>() += arm_W * force.transpose();
    jacobian.pose.diagonal().tail<3>() -= Vector3::Constant(force.dot(arm_W));
}

}  // namespace fulcrum
