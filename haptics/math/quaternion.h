// Rotations as unit quaternions, and as an angle about an axis.
//
//   q = (w, v): by `angle` about the unit axis a: w = cos(angle / 2), v = a sin(angle / 2);    q and -q turn alike
//   q p turns as p first, then q does; q u = u + 2 w (v x u) + 2 v x (v x u)
// Operators assume unit quaternions where they turn something; they never make them so themselves.
//
// Thread: any. Cost: that of the arithmetic.
// Source: J. Kuipers 1999, Quaternions and rotation sequences, chapters 5 and 7; K. Shoemake 1985, Animating rotation with
// quaternion curves, SIGGRAPH (slerp).
#pragma once

#include "haptics/math/matrix.h"

#include <cmath>
#include <limits>

namespace fulcrum {

// NOLINTBEGIN(readability-identifier-naming): names that readers of Eigen know.

/// By `angle` radians about the unit vector `axis`, the right hand's way.
template <class T>
class AngleAxisOf {
  public:
    constexpr AngleAxisOf(T angle, const Matrix<T, 3, 1>& axis) noexcept
        : angle_(angle), axis_(axis) {}
    /// The angle lies from 0 to pi; the axis of none is x.
    template <class Q>
    explicit AngleAxisOf(const Q& q) noexcept requires requires {
        q.vec();
    }
    {
        const T length = q.vec().norm();
        angle_ = T(2) * std::atan2(length, std::abs(q.w()));
        axis_ =
            length > T(0) ? q.vec() / (q.w() < T(0) ? -length : length) : Matrix<T, 3, 1>::UnitX();
    }
    [[nodiscard]] constexpr T angle() const noexcept { return angle_; }
    [[nodiscard]] constexpr const Matrix<T, 3, 1>& axis() const noexcept { return axis_; }
    [[nodiscard]] Matrix<T, 3, 3> toRotationMatrix() const noexcept;

  private:
    T angle_{};
    Matrix<T, 3, 1> axis_{Matrix<T, 3, 1>::UnitX()};
};

template <class T>
class QuaternionOf {
  public:
    using Vector = Matrix<T, 3, 1>;
    using Rotation = Matrix<T, 3, 3>;

    /// Unset, as a double is.
    QuaternionOf() = default;
    constexpr QuaternionOf(T w, T x, T y, T z) noexcept : v_(x, y, z, w) {}
    /// Of x, y, z, w.
    constexpr explicit QuaternionOf(const Matrix<T, 4, 1>& coeffs) noexcept : v_(coeffs) {}
    // NOLINTNEXTLINE(google-explicit-constructor): the same rotation.
    QuaternionOf(const AngleAxisOf<T>& turn) noexcept {
        const T half = T(0.5) * turn.angle();
        const Vector v = std::sin(half) * turn.axis();
        v_ = {v.x(), v.y(), v.z(), std::cos(half)};
    }
    /// Of a rotation's matrix.
    explicit QuaternionOf(const Rotation& R) noexcept {
        const T trace = R.trace();
        if (trace > T(0)) {
            const T root = std::sqrt(trace + T(1));
            const T by = T(0.5) / root;
            v_ = {(R(2, 1) - R(1, 2)) * by, (R(0, 2) - R(2, 0)) * by, (R(1, 0) - R(0, 1)) * by,
                  T(0.5) * root};
            return;
        }
        // The largest of x, y, z is far from zero, so that dividing by it loses nothing.
        int i = R(1, 1) > R(0, 0) ? 1 : 0;
        i = R(2, 2) > R(i, i) ? 2 : i;
        const int j = (i + 1) % 3;
        const int k = (j + 1) % 3;
        const T root = std::sqrt(R(i, i) - R(j, j) - R(k, k) + T(1));
        const T by = T(0.5) / root;
        v_[i] = T(0.5) * root;
        v_[3] = (R(k, j) - R(j, k)) * by;
        v_[j] = (R(j, i) + R(i, j)) * by;
        v_[k] = (R(k, i) + R(i, k)) * by;
    }
    [[nodiscard]] static constexpr QuaternionOf Identity() noexcept { return {1, 0, 0, 0}; }
    constexpr QuaternionOf& setIdentity() noexcept { return *this = Identity(); }
    /// The shortest turn that brings the direction of `a` to that of `b`; neither is zero.
    [[nodiscard]] static QuaternionOf FromTwoVectors(const Vector& a, const Vector& b) noexcept {
        const Vector from = a.normalized();
        const Vector to = b.normalized();
        const T cosine = from.dot(to);
        // Half a turn, about any axis across.
        if (cosine < T(-1) + Matrix<T, 3, 1>::kSlight) {
            int least = 0;
            from.cwiseAbs().minCoeff(&least);
            const Vector axis = from.cross(Vector::Unit(least)).normalized();
            return QuaternionOf(0, axis.x(), axis.y(), axis.z());
        }
        const T twice = std::sqrt((T(1) + cosine) * T(2));
        const Vector v = from.cross(to) / twice;
        return QuaternionOf(T(0.5) * twice, v.x(), v.y(), v.z());
    }

    [[nodiscard]] constexpr const T& x() const noexcept { return v_.x(); }
    [[nodiscard]] constexpr const T& y() const noexcept { return v_.y(); }
    [[nodiscard]] constexpr const T& z() const noexcept { return v_.z(); }
    [[nodiscard]] constexpr const T& w() const noexcept { return v_.w(); }
    [[nodiscard]] constexpr T& x() noexcept { return v_.x(); }
    [[nodiscard]] constexpr T& y() noexcept { return v_.y(); }
    [[nodiscard]] constexpr T& z() noexcept { return v_.z(); }
    [[nodiscard]] constexpr T& w() noexcept { return v_.w(); }
    /// x, y, z, w.
    [[nodiscard]] constexpr const Matrix<T, 4, 1>& coeffs() const noexcept { return v_; }
    [[nodiscard]] constexpr Matrix<T, 4, 1>& coeffs() noexcept { return v_; }
    [[nodiscard]] constexpr Vector vec() const noexcept { return {x(), y(), z()}; }
    [[nodiscard]] constexpr auto vec() noexcept { return v_.template head<3>(); }

    [[nodiscard]] constexpr T dot(const QuaternionOf& q) const noexcept { return v_.dot(q.v_); }
    [[nodiscard]] constexpr T squaredNorm() const noexcept { return v_.squaredNorm(); }
    [[nodiscard]] T norm() const noexcept { return v_.norm(); }
    void normalize() noexcept { v_ = v_.normalized(); }
    [[nodiscard]] QuaternionOf normalized() const noexcept { return QuaternionOf(v_.normalized()); }
    [[nodiscard]] constexpr QuaternionOf conjugate() const noexcept {
        return {w(), -x(), -y(), -z()};
    }
    /// Zero where it is zero.
    [[nodiscard]] constexpr QuaternionOf inverse() const noexcept {
        const T square = squaredNorm();
        return QuaternionOf(square > T(0) ? conjugate().v_ / square : Matrix<T, 4, 1>::Zero());
    }
    [[nodiscard]] constexpr QuaternionOf operator*(const QuaternionOf& q) const noexcept {
        return {w() * q.w() - x() * q.x() - y() * q.y() - z() * q.z(),
                w() * q.x() + x() * q.w() + y() * q.z() - z() * q.y(),
                w() * q.y() + y() * q.w() + z() * q.x() - x() * q.z(),
                w() * q.z() + z() * q.w() + x() * q.y() - y() * q.x()};
    }
    constexpr QuaternionOf& operator*=(const QuaternionOf& q) noexcept { return *this = *this * q; }
    [[nodiscard]] constexpr Vector operator*(const Vector& u) const noexcept {
        const Vector v(x(), y(), z());
        const Vector across = v.cross(u);
        const Vector twice = across + across;
        return u + w() * twice + v.cross(twice);
    }
    [[nodiscard]] friend constexpr bool operator==(const QuaternionOf& a,
                                                   const QuaternionOf& b) noexcept {
        return a.v_ == b.v_;
    }
    [[nodiscard]] constexpr Rotation toRotationMatrix() const noexcept {
        const T tx = T(2) * x();
        const T ty = T(2) * y();
        const T tz = T(2) * z();
        const T twx = tx * w(), twy = ty * w(), twz = tz * w();
        const T txx = tx * x(), txy = ty * x(), txz = tz * x();
        const T tyy = ty * y(), tyz = tz * y(), tzz = tz * z();
        Rotation R;
        R(0, 0) = T(1) - (tyy + tzz);
        R(0, 1) = txy - twz;
        R(0, 2) = txz + twy;
        R(1, 0) = txy + twz;
        R(1, 1) = T(1) - (txx + tzz);
        R(1, 2) = tyz - twx;
        R(2, 0) = txz - twy;
        R(2, 1) = tyz + twx;
        R(2, 2) = T(1) - (txx + tyy);
        return R;
    }
    /// Radians from one to the other, 0 to pi.
    [[nodiscard]] T angularDistance(const QuaternionOf& q) const noexcept {
        const QuaternionOf between = *this * q.conjugate();
        return T(2) * std::atan2(Vector(between.vec()).norm(), std::abs(between.w()));
    }
    /// On the shorter way to `q` at an even rate: 0 here, 1 there.
    [[nodiscard]] QuaternionOf slerp(T share, const QuaternionOf& q) const noexcept {
        const T cosine = dot(q);
        const T along = std::abs(cosine);
        T here = T(1) - share;
        T there = share;
        if (along < T(1) - std::numeric_limits<T>::epsilon()) {
            const T angle = std::acos(along);
            const T sine = std::sin(angle);
            here = std::sin((T(1) - share) * angle) / sine;
            there = std::sin(share * angle) / sine;
        }
        return QuaternionOf(here * v_ + (cosine < T(0) ? -there : there) * q.v_);
    }
    [[nodiscard]] bool isApprox(const QuaternionOf& q,
                                T share = Matrix<T, 4, 1>::kSlight) const noexcept {
        return v_.isApprox(q.v_, share);
    }
    template <class U>
    [[nodiscard]] constexpr QuaternionOf<U> cast() const noexcept {
        return {static_cast<U>(w()), static_cast<U>(x()), static_cast<U>(y()), static_cast<U>(z())};
    }

  private:
    Matrix<T, 4, 1> v_;
};

template <class T>
Matrix<T, 3, 3> AngleAxisOf<T>::toRotationMatrix() const noexcept {
    return QuaternionOf<T>(*this).toRotationMatrix();
}
template <class T>
[[nodiscard]] QuaternionOf<T> operator*(const AngleAxisOf<T>& a, const AngleAxisOf<T>& b) noexcept {
    return QuaternionOf<T>(a) * QuaternionOf<T>(b);
}
template <class T>
[[nodiscard]] QuaternionOf<T> operator*(const AngleAxisOf<T>& a,
                                        const QuaternionOf<T>& b) noexcept {
    return QuaternionOf<T>(a) * b;
}
template <class T>
[[nodiscard]] Matrix<T, 3, 1> operator*(const AngleAxisOf<T>& turn,
                                        const Matrix<T, 3, 1>& v) noexcept {
    return QuaternionOf<T>(turn) * v;
}

using Quaternion = QuaternionOf<double>;
using AngleAxis = AngleAxisOf<double>;

// NOLINTEND(readability-identifier-naming)

}  // namespace fulcrum
