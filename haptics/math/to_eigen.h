// Between the small types and Eigen's, for the few sources that need a matrix library. No header includes this one.
//
// Thread: any. Cost: a copy; on the heap where the size is known at run time only.
#pragma once

#include "haptics/math/matrix.h"
#include "haptics/math/plain_eigen.h"

#include <Eigen/Core>

namespace fulcrum {

/// Of a matrix whose size is known.
template <class T, int R, int C>
[[nodiscard]] Eigen::Matrix<T, R, C> to_eigen(const Matrix<T, R, C>& m) {
    return Eigen::Map<const Eigen::Matrix<T, R, C>>(m.data());
}
/// Of any other: what has rows(), cols() and coeff(i, j).
template <class M>
[[nodiscard]] Eigen::MatrixXd to_eigen(const M& m) {
    return Eigen::MatrixXd::NullaryExpr(
        m.rows(), m.cols(), [&](Eigen::Index i, Eigen::Index j) { return m.coeff(i, j); });
}

/// Of Eigen's matrix of the same size.
template <class E, class T = typename E::Scalar>
[[nodiscard]] Matrix<T, E::RowsAtCompileTime, E::ColsAtCompileTime> from_eigen(
    const Eigen::MatrixBase<E>& m) {
    Matrix<T, E::RowsAtCompileTime, E::ColsAtCompileTime> copy;
    for (int j = 0; j < m.cols(); ++j) {
        for (int i = 0; i < m.rows(); ++i) {
            copy.coeffRef(i, j) = m(i, j);
        }
    }
    return copy;
}

}  // namespace fulcrum
