// Rotations as vectors: the exponential map of SO(3), its inverse, and their derivatives.
//
//   exp(phi) = (cos |phi|/2, phi/|phi| sin |phi|/2)          log(exp(phi)) = phi for |phi| < pi
//   exp(phi + d) = exp(J_l(phi) d) exp(phi) + O(d^2)         J_l the left Jacobian
//   log(exp(phi) exp(d)) = phi + J_r(phi)^-1 d + O(d^2)      J_r(phi) = J_l(-phi) the right one
// Thread: any. Cost: one sine and cosine, or one arctangent.
// Source: J. Sola, J. Deray, D. Atchuthan 2018, A micro Lie theory for state estimation in
// robotics, appendix on unit quaternions (exponential and logarithm maps) and section on Jacobians.
#pragma once

#include "haptics/math/spatial.h"

#include <cmath>

namespace fulcrum {

/// The rotation about `rotation_vector` by its length in radians. Normalised to rounding.
[[nodiscard]] inline Quaternion compute_exp(const Vector3& rotation_vector) noexcept {
    // Below this angle the series 1/2 - phi^2/48 is exact to double precision.
    constexpr double kSmallAngle_rad = 1.0e-4;
    const double angle_rad = rotation_vector.norm();
    const double factor = angle_rad < kSmallAngle_rad ? 0.5 - angle_rad * angle_rad / 48.0
                                                      : std::sin(0.5 * angle_rad) / angle_rad;
    const Vector3 imaginary = factor * rotation_vector;
    Quaternion q(std::cos(0.5 * angle_rad), imaginary.x(), imaginary.y(), imaginary.z());
    q.normalize();
    return q;
}

/// The shortest rotation vector (radians, length at most pi) whose exponential is the unit
/// quaternion `q`.
[[nodiscard]] inline Vector3 compute_log(const Quaternion& q) noexcept {
    // q and -q turn alike; the one with positive real part takes the shorter way.
    const double sign = q.w() < 0.0 ? -1.0 : 1.0;
    const Vector3 imaginary = sign * q.vec();
    const double sine = imaginary.norm();
    const double cosine = sign * q.w();
    constexpr double kSmallSine = 1.0e-9;  // there the angle is twice the sine to double precision
    return sine < kSmallSine ? Vector3(2.0 * imaginary)
                             : Vector3(imaginary * (2.0 * std::atan2(sine, cosine) / sine));
}

/// The matrix of the cross product: skew(a) b = a x b.
[[nodiscard]] inline Matrix3 compute_skew(const Vector3& a) noexcept {
    Matrix3 m;
    m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    return m;
}

/// Below this angle (radians) two terms of a series are exact to double precision, and the closed
/// forms, which subtract almost equal numbers, are not.
inline constexpr double kJacobianSeries_rad = 1.0e-3;

/// J_l(phi) = I + (1 - cos a)/a^2 [phi] + (a - sin a)/a^3 [phi]^2, a = |phi| in radians.
[[nodiscard]] inline Matrix3 compute_left_jacobian(const Vector3& phi) noexcept {
    const double squared = phi.squaredNorm();
    const double angle = std::sqrt(squared);
    const bool small = angle < kJacobianSeries_rad;
    const double first =
        small ? 0.5 - squared / 24.0 : 2.0 * std::pow(std::sin(0.5 * angle) / angle, 2);
    const double second =
        small ? 1.0 / 6.0 - squared / 120.0 : (angle - std::sin(angle)) / (squared * angle);
    const Matrix3 skew = compute_skew(phi);
    return Matrix3::Identity() + first * skew + second * skew * skew;
}

/// J_r(phi)^-1 = I + [phi]/2 + (1 - (a/2) cot(a/2))/a^2 [phi]^2 for a = |phi| <= pi.
[[nodiscard]] inline Matrix3 compute_right_jacobian_inverse(const Vector3& phi) noexcept {
    const double squared = phi.squaredNorm();
    const double half = 0.5 * std::sqrt(squared);
    const double second = 2.0 * half < kJacobianSeries_rad
                              ? 1.0 / 12.0 + squared / 720.0
                              : (1.0 - half * std::cos(half) / std::sin(half)) / squared;
    const Matrix3 skew = compute_skew(phi);
    return Matrix3::Identity() + 0.5 * skew + second * skew * skew;
}

}  // namespace fulcrum
