// Rotations as vectors: the exponential map of SO(3) and its inverse.
//
//   exp(phi) = (cos |phi|/2, phi/|phi| sin |phi|/2)          log(exp(phi)) = phi for |phi| < pi
// Thread: any. Cost: one sine and cosine, or one arctangent.
// Source: J. Sola, J. Deray, D. Atchuthan 2018, A micro Lie theory for state estimation in
// robotics, appendix on unit quaternions (exponential and logarithm maps).
#pragma once

#include "haptics/math/spatial.h"

#include <cmath>

namespace fulcrum {

/// The rotation about `rotation_vector` by its length in radians. Exactly normalised.
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

}  // namespace fulcrum
