// A map of space that keeps straight lines: p -> linear p + translation.
//
// `rotate`, `scale` and `translate` act on a point before all that the map did so far.
// Thread: any; a value. Cost: that of the arithmetic.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

// NOLINTBEGIN(readability-identifier-naming): names that readers of Eigen know.

class Affine {
  public:
    Affine() = default;
    explicit Affine(const AngleAxis& turn) noexcept : linear_(turn.toRotationMatrix()) {}
    [[nodiscard]] static Affine Identity() noexcept { return {}; }
    [[nodiscard]] static Affine at(const Vector3& translation) noexcept {
        Affine X;
        X.translation_ = translation;
        return X;
    }

    void rotate(const Quaternion& turn) noexcept { linear_ *= turn.toRotationMatrix(); }
    void scale(const Vector3& factors) noexcept { linear_ *= factors.asDiagonal(); }
    void scale(double factor) noexcept { linear_ *= factor; }
    void translate(const Vector3& by) noexcept { translation_ += linear_ * by; }

    [[nodiscard]] const Matrix3& linear() const noexcept { return linear_; }
    [[nodiscard]] const Vector3& translation() const noexcept { return translation_; }
    [[nodiscard]] Vector3 operator*(const Vector3& p) const noexcept {
        return linear_ * p + translation_;
    }
    /// Of homogeneous coordinates.
    [[nodiscard]] Matrix4 matrix() const noexcept {
        Matrix4 m = Matrix4::Identity();
        m.topLeftCorner<3, 3>() = linear_;
        m.topRightCorner<3, 1>() = translation_;
        return m;
    }

  private:
    Matrix3 linear_{Matrix3::Identity()};
    Vector3 translation_{Vector3::Zero()};
};

// NOLINTEND(readability-identifier-naming)

}  // namespace fulcrum
