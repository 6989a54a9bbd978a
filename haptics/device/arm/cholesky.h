// Linear systems of an arm's size with a symmetric, positive definite matrix, without anything that might allocate.
//
//   A = L L^T      L lower triangular; x = L^-T L^-1 b; B^T A^-1 B = Y^T Y with Y = L^-1 B
// Thread: any. Cost: n^3 / 6 multiplications for L, n^2 a solution, half of it for L^-1 b.
// Source: any textbook; G. Golub, C. Van Loan 2013, Matrix computations, algorithm 4.2.1.
#pragma once

#include "haptics/math/matrix.h"

#include <cmath>

namespace fulcrum {

/// Puts L into the lower half of `a`, of which that half alone is read.
template <class Matrix>
void factor_cholesky(Matrix& a) noexcept {
    // No index is checked again: a check costs as much as what it guards.
    const Index n = a.rows();
    for (Index j = 0; j < n; ++j) {
        double pivot = a.coeff(j, j);
        for (Index k = 0; k < j; ++k) {
            pivot -= a.coeff(j, k) * a.coeff(j, k);
        }
        pivot = std::sqrt(pivot);
        a.coeffRef(j, j) = pivot;
        for (Index i = j + 1; i < n; ++i) {
            double below = a.coeff(i, j);
            for (Index k = 0; k < j; ++k) {
                below -= a.coeff(i, k) * a.coeff(j, k);
            }
            a.coeffRef(i, j) = below / pivot;
        }
    }
}

/// Replaces each row b^T by (L^-1 b)^T; `l` from factor_cholesky, with as many rows as `rows` has columns.
template <class Matrix, class Rows>
void solve_lower(const Matrix& l, Rows& rows) noexcept {
    for (Index i = 0; i < l.rows(); ++i) {
        auto column = rows.col(i);
        for (Index k = 0; k < i; ++k) {
            column -= l.coeff(i, k) * rows.col(k);
        }
        column /= l.coeff(i, i);
    }
}

/// Replaces b by A^-1 b; `l` from factor_cholesky.
template <class Matrix, class Column>
void solve_cholesky(const Matrix& l, Column& column) noexcept {
    const Index n = l.rows();
    for (Index i = 0; i < n; ++i) {
        double value = column.coeff(i);
        for (Index k = 0; k < i; ++k) {
            value -= l.coeff(i, k) * column.coeff(k);
        }
        column.coeffRef(i) = value / l.coeff(i, i);
    }
    for (Index i = n - 1; i >= 0; --i) {
        double value = column.coeff(i);
        for (Index k = i + 1; k < n; ++k) {
            value -= l.coeff(k, i) * column.coeff(k);
        }
        column.coeffRef(i) = value / l.coeff(i, i);
    }
}

}  // namespace fulcrum
