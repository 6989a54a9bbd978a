// The exact motion of a rigid body that nothing turns, started near its middle axis: what integrators are held against.
//
// With I1 < I2 < I3 and L^2 > 2 E I2 (sn, cn, dn of tau = rate t, parameter m):
//   w1 = A1 cn,  w2 = A2 sn,  w3 = A3 dn               A1, A3, rate from A2, m and the moments
//   R  = Rz(phi) Rx(theta) Rz(psi), L along z:  (I1 w1, I2 w2, I3 w3) = |L| (sin theta sin psi, sin theta cos psi, cos theta)
//   dphi/dt = |L| (I1 w1^2 + I2 w2^2) / (I1^2 w1^2 + I2^2 w2^2)
// sn, cn, dn by the arithmetic-geometric mean; phi by Gauss-Legendre quadrature of that smooth function, to rounding.
// At time 0 tau is K(m): the body turns about its middle axis, all but sqrt(1 - m) of A3. As m goes to 1 it lingers there
// longer between two somersaults.
//
// Source: L. Landau, E. Lifshitz, Mechanics, section 37. M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 16.4.
#pragma once

#include "haptics/dynamics/rigid_state.h"

#include <array>
#include <cmath>

namespace fulcrum::test {

struct JacobiFunctions {
    double sn, cn, dn;
};

/// sn, cn and dn of `u` with parameter m = k^2 in [0, 1).
inline JacobiFunctions compute_jacobi(double u, double m) {
    constexpr int kMost = 16;
    std::array<double, kMost> a{};
    std::array<double, kMost> c{};
    a[0] = 1.0;
    double b = std::sqrt(1.0 - m);
    int n = 0;
    for (c[0] = std::sqrt(m); n + 1 < kMost && c[n] > 1.0e-16; ++n) {
        a[n + 1] = 0.5 * (a[n] + b);
        c[n + 1] = 0.5 * (a[n] - b);
        b = std::sqrt(a[n] * b);
    }
    double angle = std::ldexp(a[n] * u, n);
    for (int i = n; i > 0; --i) {
        angle = 0.5 * (angle + std::asin(c[i] / a[i] * std::sin(angle)));
    }
    const double sn = std::sin(angle);
    return {sn, std::cos(angle), std::sqrt(1.0 - m * sn * sn)};
}

class FreeRotation {
  public:
    /// Moments I1 < I2 < I3; the largest spin about the middle axis in rad/s; 0 < m < 1.
    FreeRotation(const Vector3& moments_kg_m2, double middle_spin_rad_per_s, double m)
        : moments_(moments_kg_m2), m_(m) {
        const double i1 = moments_[0];
        const double i2 = moments_[1];
        const double i3 = moments_[2];
        const double less = middle_spin_rad_per_s * middle_spin_rad_per_s * i2 * (i3 - i2);
        const double more = (i2 - i1) * less / ((i3 - i2) * m);  // L^2 - 2 E I1
        peaks_ = {std::sqrt(less / (i1 * (i3 - i1))), middle_spin_rad_per_s,
                  std::sqrt(more / (i3 * (i3 - i1)))};
        rate_ = std::sqrt((i3 - i2) * more / (i1 * i2 * i3));
        quarter_ = std::comp_ellint_1(std::sqrt(m));
        momentum_ = moments_.cwiseProduct(compute_spin_B(0.0)).norm();
    }

    /// Seconds from one somersault to the next.
    [[nodiscard]] double somersault_s() const { return 2.0 * quarter_ / rate_; }
    /// |L|, along z of W.
    [[nodiscard]] double angular_momentum() const { return momentum_; }
    /// Spin in the body's frame, rad/s.
    [[nodiscard]] Vector3 compute_spin_B(double time_s) const {
        const JacobiFunctions f = compute_jacobi(rate_ * time_s + quarter_, m_);
        return {peaks_[0] * f.cn, peaks_[1] * f.sn, peaks_[2] * f.dn};
    }
    /// The whole state; times must not fall from call to call (phi is carried on).
    [[nodiscard]] RigidState compute_state(double time_s) {
        carry_on_to(time_s);
        const Vector3 spin_B = compute_spin_B(time_s);
        const Vector3 along = moments_.cwiseProduct(spin_B) / momentum_;
        const double theta = std::atan2(std::hypot(along.x(), along.y()), along.z());
        const double psi = std::atan2(along.x(), along.y());
        const Quaternion q = about(Vector3::UnitZ(), phi_) * about(Vector3::UnitX(), theta) *
                             about(Vector3::UnitZ(), psi);
        RigidState state;
        state.pose_W.orientation = q;
        state.velocity_W.angular = q * spin_B;
        return state;
    }

  private:
    static Quaternion about(const Vector3& axis, double angle_rad) {
        return Quaternion(AngleAxis(angle_rad, axis));
    }
    [[nodiscard]] double compute_precession(double time_s) const {
        const Vector3 w = compute_spin_B(time_s);
        const Vector3 l = moments_.cwiseProduct(w);
        return momentum_ * (l.x() * w.x() + l.y() * w.y()) / (l.x() * l.x() + l.y() * l.y());
    }
    void carry_on_to(double time_s) {
        // Panels of a hundredth of the shortest time that occurs; five points are exact to degree 9.
        constexpr std::array<double, 3> kNode{0.0, 0.53846931010568309, 0.90617984593866399};
        constexpr std::array<double, 3> kWeight{0.56888888888888889, 0.47862867049936647,
                                                0.23692688505618909};
        const double widest_s = 0.01 / rate_;
        const int n = static_cast<int>(std::ceil((time_s - at_s_) / widest_s));
        const double half_s = n > 0 ? 0.5 * (time_s - at_s_) / n : 0.0;
        for (int i = 0; i < n; ++i) {
            const double middle_s = at_s_ + (2 * i + 1) * half_s;
            double sum = kWeight[0] * compute_precession(middle_s);
            for (int k = 1; k < 3; ++k) {
                sum += kWeight[k] * (compute_precession(middle_s - kNode[k] * half_s) +
                                     compute_precession(middle_s + kNode[k] * half_s));
            }
            phi_ += half_s * sum;
        }
        at_s_ = time_s;
    }

    Vector3 moments_;
    double m_;
    Vector3 peaks_;
    double rate_ = 0.0;     // dtau/dt, 1/s
    double quarter_ = 0.0;  // K(m)
    double momentum_ = 0.0;
    double at_s_ = 0.0;  // how far phi has come
    double phi_ = 0.0;
};

/// The angle between two orientations, radians.
inline double compute_angle_rad(const Quaternion& a, const Quaternion& b) {
    return 2.0 * std::atan2((a.conjugate() * b).vec().norm(), std::abs(a.dot(b)));
}

}  // namespace fulcrum::test
