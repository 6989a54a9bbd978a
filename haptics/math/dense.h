// Small dense systems and symmetric matrices' axes, compiled once: what a matrix library is for, behind types that need none.
//
//   Cholesky  A = L L^T, of a symmetric, positive definite matrix, of which the lower half is read
//   LU        P A = L U with the largest pivot of each column
//   axes      A = V diag(values) V^T, V a rotation or a mirroring, values from the least to the largest
//
// Thread: any; nothing is allocated but by `invert`. Cost: 0.1 to 0.5 us.
// Source: any textbook; G. Golub, C. Van Loan 2013, Matrix computations, algorithms 4.2.1, 3.4.1, 8.3.3; by Eigen.
#pragma once

#include "haptics/math/matrix.h"

#include <cstddef>
#include <optional>
#include <span>

namespace fulcrum {

/// L, zero above; none where A is not positive definite.
[[nodiscard]] std::optional<Matrix3> compute_cholesky(const Matrix3& A) noexcept;

/// A^-1 b by Cholesky; not finite, or nothing meant, where A is not positive definite.
[[nodiscard]] Vector6 solve_cholesky(const Matrix6& A, const Vector6& b) noexcept;

/// A^-1 b by LU; not finite where A is singular. `pivots`, where given: U's diagonal.
[[nodiscard]] Vector6 solve_lu(const Matrix6& A, const Vector6& b,
                               Vector6* pivots = nullptr) noexcept;

/// Replaces n x n numbers, column after column, by those of the inverse, by LU with the largest pivot of all; false where there is
/// none, and they stay. Allocates.
[[nodiscard]] bool invert(std::span<double> A, std::size_t n);

/// L^-T b, of a lower triangle.
[[nodiscard]] Vector6 solve_lower_transposed(const Matrix6& L, const Vector6& b) noexcept;

/// A symmetric matrix along its own axes.
struct SymmetricAxes {
    Vector3 values{Vector3::Zero()};    ///< from the least to the largest
    Matrix3 axes{Matrix3::Identity()};  ///< a column each, of length 1
};
/// In steps until rounding is left; the lower half is read.
[[nodiscard]] SymmetricAxes compute_symmetric_axes(const Matrix3& A) noexcept;
/// In closed form: a fifth of the time, and fewer digits where two values are nearly the same.
[[nodiscard]] SymmetricAxes compute_symmetric_axes_direct(const Matrix3& A) noexcept;

}  // namespace fulcrum
