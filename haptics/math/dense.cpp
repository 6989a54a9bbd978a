#include "haptics/math/dense.h"

#include "haptics/math/plain_eigen.h"
#include "haptics/math/to_eigen.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace fulcrum {

std::optional<Matrix3> compute_cholesky(const Matrix3& A) noexcept {
    const Eigen::LLT<Eigen::Matrix3d> factor(to_eigen(A));
    if (factor.info() != Eigen::Success) {
        return std::nullopt;
    }
    return from_eigen(Eigen::Matrix3d(factor.matrixL()));
}

Vector6 solve_cholesky(const Matrix6& A, const Vector6& b) noexcept {
    return from_eigen(to_eigen(A).llt().solve(to_eigen(b)).eval());
}

Vector6 solve_lu(const Matrix6& A, const Vector6& b, Vector6* pivots) noexcept {
    const auto lu = to_eigen(A).partialPivLu();
    if (pivots != nullptr) {
        *pivots = from_eigen(lu.matrixLU().diagonal().eval());
    }
    return from_eigen(lu.solve(to_eigen(b)).eval());
}

Vector6 solve_lower_transposed(const Matrix6& L, const Vector6& b) noexcept {
    Vector6 x = b;
    for (int i = 5; i >= 0; --i) {
        for (int j = i + 1; j < 6; ++j) {
            x[i] -= L.coeff(j, i) * x[j];
        }
        x[i] /= L.coeff(i, i);
    }
    return x;
}

SymmetricAxes compute_symmetric_axes(const Matrix3& A) noexcept {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts(to_eigen(A));
    return {from_eigen(parts.eigenvalues()), from_eigen(parts.eigenvectors())};
}

SymmetricAxes compute_symmetric_axes_direct(const Matrix3& A) noexcept {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts;
    parts.computeDirect(to_eigen(A));
    return {from_eigen(parts.eigenvalues()), from_eigen(parts.eigenvectors())};
}

}  // namespace fulcrum
