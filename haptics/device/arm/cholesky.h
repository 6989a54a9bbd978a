// Linear systems of an arm's size with a symmetric, positive definite matrix, without anything that might allocate.
//
//   A = L L^T      L lower triangular; x = L^-T L^-1 b
// Thread: any. Cost: n^3 / 6 multiplications for L, n^2 a column.
// Source: any textbook; G. Golub, C. Van Loan 2013, Matrix computations, algorithm 4.2.1.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace fulcrum {

/// Puts L into the lower half of `a`, of which that half alone is read.
template <class Matrix>
void factor_cholesky(Matrix& a) noexcept {
    for (Eigen::Index j = 0; j < a.rows(); ++j) {
        for (Eigen::Index k = 0; k < j; ++k) {
            a(j, j) -= a(j, k) * a(j, k);
        }
        a(j, j) = std::sqrt(a(j, j));
        for (Eigen::Index i = j + 1; i < a.rows(); ++i) {
            for (Eigen::Index k = 0; k < j; ++k) {
                a(i, j) -= a(i, k) * a(j, k);
            }
            a(i, j) /= a(j, j);
        }
    }
}

/// Replaces each column b by A^-1 b; `l` from factor_cholesky.
template <class Matrix, class Columns>
void solve_cholesky(const Matrix& l, Columns& columns) noexcept {
    for (Eigen::Index c = 0; c < columns.cols(); ++c) {
        for (Eigen::Index i = 0; i < l.rows(); ++i) {
            for (Eigen::Index k = 0; k < i; ++k) {
                columns(i, c) -= l(i, k) * columns(k, c);
            }
            columns(i, c) /= l(i, i);
        }
        for (Eigen::Index i = l.rows() - 1; i >= 0; --i) {
            for (Eigen::Index k = i + 1; k < l.rows(); ++k) {
                columns(i, c) -= l(k, i) * columns(k, c);
            }
            columns(i, c) /= l(i, i);
        }
    }
}

}  // namespace fulcrum
