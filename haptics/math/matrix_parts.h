// Columns, rows, corners and other parts of a matrix: views of one that can be written, values of a constant one.
//
// Thread: any. Cost: none for a view, a copy for a value.
#pragma once

#include "haptics/math/matrix_view.h"

namespace fulcrum {

// NOLINTBEGIN(readability-identifier-naming): names that readers of Eigen know.

/// What Matrix<T, R, C> inherits.
template <class T, int R, int C>
class MatrixParts {
  public:
    [[nodiscard]] constexpr auto col(Index j) noexcept {
        return MatrixView<Matrix<T, R, 1>, 1, R, T>(numbers() + j * R);
    }
    [[nodiscard]] constexpr auto col(Index j) const noexcept {
        return Matrix<T, R, 1>(numbers() + j * R);
    }
    [[nodiscard]] constexpr auto row(Index i) noexcept {
        return MatrixView<Matrix<T, 1, C>, 1, R, T>(numbers() + i);
    }
    [[nodiscard]] constexpr auto row(Index i) const noexcept {
        return MatrixView<Matrix<T, 1, C>, 1, R, const T>(numbers() + i);
    }
    [[nodiscard]] constexpr auto diagonal() noexcept {
        return MatrixView<Matrix<T, R, 1>, R + 1, R, T>(numbers());
    }
    [[nodiscard]] constexpr Matrix<T, R, 1> diagonal() const noexcept {
        return MatrixView<Matrix<T, R, 1>, R + 1, R, const T>(numbers());
    }
    template <int N>
    [[nodiscard]] constexpr auto head() noexcept {
        return block<N, 1>(0, 0);
    }
    template <int N>
    [[nodiscard]] constexpr auto head() const noexcept {
        return block<N, 1>(0, 0);
    }
    template <int N>
    [[nodiscard]] constexpr auto tail() noexcept {
        return block<N, 1>(R - N, 0);
    }
    template <int N>
    [[nodiscard]] constexpr auto tail() const noexcept {
        return block<N, 1>(R - N, 0);
    }
    template <int N, int M>
    [[nodiscard]] constexpr auto block(Index i, Index j) noexcept {
        assert(i >= 0 && i + N <= R && j >= 0 && j + M <= C);
        return MatrixView<Matrix<T, N, M>, 1, R, T>(numbers() + i + j * R);
    }
    template <int N, int M>
    [[nodiscard]] constexpr Matrix<T, N, M> block(Index i, Index j) const noexcept {
        assert(i >= 0 && i + N <= R && j >= 0 && j + M <= C);
        return MatrixView<Matrix<T, N, M>, 1, R, const T>(numbers() + i + j * R);
    }
    template <int N, int M>
    [[nodiscard]] constexpr auto topLeftCorner() noexcept {
        return block<N, M>(0, 0);
    }
    template <int N, int M>
    [[nodiscard]] constexpr auto topLeftCorner() const noexcept {
        return block<N, M>(0, 0);
    }
    template <int N, int M>
    [[nodiscard]] constexpr auto topRightCorner() noexcept {
        return block<N, M>(0, C - M);
    }
    template <int N, int M>
    [[nodiscard]] constexpr auto topRightCorner() const noexcept {
        return block<N, M>(0, C - M);
    }
    template <int N, int M>
    [[nodiscard]] constexpr auto bottomLeftCorner() noexcept {
        return block<N, M>(R - N, 0);
    }
    template <int N, int M>
    [[nodiscard]] constexpr auto bottomLeftCorner() const noexcept {
        return block<N, M>(R - N, 0);
    }
    template <int N, int M>
    [[nodiscard]] constexpr auto bottomRightCorner() noexcept {
        return block<N, M>(R - N, C - M);
    }
    template <int N, int M>
    [[nodiscard]] constexpr auto bottomRightCorner() const noexcept {
        return block<N, M>(R - N, C - M);
    }
    template <int N>
    [[nodiscard]] constexpr auto leftCols() noexcept {
        return block<R, N>(0, 0);
    }
    template <int N>
    [[nodiscard]] constexpr auto leftCols() const noexcept {
        return block<R, N>(0, 0);
    }
    template <int N>
    [[nodiscard]] constexpr auto rightCols() noexcept {
        return block<R, N>(0, C - N);
    }
    template <int N>
    [[nodiscard]] constexpr auto rightCols() const noexcept {
        return block<R, N>(0, C - N);
    }
    template <int N>
    [[nodiscard]] constexpr auto topRows() noexcept {
        return block<N, C>(0, 0);
    }
    template <int N>
    [[nodiscard]] constexpr auto topRows() const noexcept {
        return block<N, C>(0, 0);
    }
    template <int N>
    [[nodiscard]] constexpr auto bottomRows() noexcept {
        return block<N, C>(R - N, 0);
    }
    template <int N>
    [[nodiscard]] constexpr auto bottomRows() const noexcept {
        return block<N, C>(R - N, 0);
    }
    /// A view of what stays; of what goes, a matrix.
    [[nodiscard]] constexpr auto transpose() const& noexcept {
        return MatrixView<Matrix<T, C, R>, R, 1, const T>(numbers());
    }
    [[nodiscard]] constexpr Matrix<T, C, R> transpose() const&& noexcept {
        return MatrixView<Matrix<T, C, R>, R, 1, const T>(numbers());
    }

  private:
    [[nodiscard]] constexpr T* numbers() noexcept {
        return static_cast<Matrix<T, R, C>&>(*this).data();
    }
    [[nodiscard]] constexpr const T* numbers() const noexcept {
        return static_cast<const Matrix<T, R, C>&>(*this).data();
    }
};

// NOLINTEND(readability-identifier-naming)

}  // namespace fulcrum
