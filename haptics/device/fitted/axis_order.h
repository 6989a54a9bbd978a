// Which axis of an arm is which of the person's, for an arm that stands turned or whose maker counts otherwise.
//
//   p_D = A p_A,   A a signed permutation: one +1 or -1 in each row and each column, so that A^T A = 1
//   f_A = A^T f_D                       the same power in either frame:  f_A . v_A = f_D . v_D
//   P = det(A) A, a proper turn         angular velocity and torque are pseudovectors: w_D = P w_A, t_A = P^T t_D
//   q_D = P q_A P^-1                    A R A^T = P R P^T, for both signs cancel
// A mirror (det A = -1) is among them. It turns poses and forces alike: an arm that pushes against what it is told stays one.
//
// Thread: any. Cost: a few multiplications.
// Source: H. Goldstein, C. Poole, J. Safko, Classical Mechanics, 3rd ed., section 4.8, polar and axial vectors under reflection.
#pragma once

#include "haptics/base/error.h"
#include "haptics/math/spatial.h"

#include <optional>
#include <string>
#include <string_view>

namespace fulcrum {

class AxisOrder {
  public:
    /// As the arm says: x to the right, y up, z to who holds it.
    AxisOrder() = default;

    /// From words such as "-x,y,z" or "z,y,-x": what the person's right, up and towards them are at the arm. Refuses what is none, and an
    /// axis named twice.
    [[nodiscard]] static Expected<AxisOrder> read(std::string_view text);
    /// From a signed permutation; nothing of a matrix that is none.
    [[nodiscard]] static std::optional<AxisOrder> of(const Matrix3& axes) noexcept;
    /// The words that `read` takes.
    [[nodiscard]] std::string text() const;

    /// True where nothing is turned.
    [[nodiscard]] bool is_plain() const noexcept { return axes_ == Matrix3::Identity(); }
    [[nodiscard]] const Matrix3& matrix() const noexcept { return axes_; }

    /// A place, a velocity or a force of the arm as the person has it.
    [[nodiscard]] Vector3 turn(const Vector3& vector_A) const noexcept { return axes_ * vector_A; }
    [[nodiscard]] Quaternion turn(const Quaternion& orientation_A) const noexcept {
        return proper_ * orientation_A * proper_.conjugate();
    }
    /// What the person is to feel, as the arm gives it.
    [[nodiscard]] Wrench turn_back(const Wrench& wrench_D) const noexcept {
        return {axes_.transpose() * wrench_D.force, proper_.conjugate() * wrench_D.torque};
    }

  private:
    explicit AxisOrder(const Matrix3& axes)
        : axes_(axes), proper_(Matrix3(axes.determinant() * axes)) {
        proper_.normalize();
    }

    Matrix3 axes_{Matrix3::Identity()};
    Quaternion proper_{Quaternion::Identity()};
};

}  // namespace fulcrum
