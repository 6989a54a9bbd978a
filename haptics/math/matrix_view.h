// Parts of matrices that can be written, products whatever their factors are parts of, and how a matrix is filled. Used by matrix.h, which
// says what all of it is.
//
// Thread: any. Cost: that of the arithmetic.
#pragma once

#include <cassert>
#include <cstddef>
#include <utility>

namespace fulcrum {

// NOLINTBEGIN(readability-identifier-naming): names that readers of Eigen know.

using Index = std::ptrdiff_t;

template <class T, int R, int C>
class Matrix;
template <class M, int RowStep, int ColumnStep, class Number>
class MatrixView;

using Vector2 = Matrix<double, 2, 1>;
using Vector3 = Matrix<double, 3, 1>;
using Vector4 = Matrix<double, 4, 1>;
using Vector6 = Matrix<double, 6, 1>;
using Matrix2 = Matrix<double, 2, 2>;
using Matrix3 = Matrix<double, 3, 3>;
using Matrix4 = Matrix<double, 4, 4>;
using Matrix6 = Matrix<double, 6, 6>;
using Vector2f = Matrix<float, 2, 1>;
using Vector3f = Matrix<float, 3, 1>;
using Vector4f = Matrix<float, 4, 1>;
using Matrix3f = Matrix<float, 3, 3>;
using Matrix4f = Matrix<float, 4, 4>;
using Vector3i = Matrix<int, 3, 1>;

template <class M>
inline constexpr bool is_matrix = false;
template <class T, int R, int C>
inline constexpr bool is_matrix<Matrix<T, R, C>> = true;
template <class M, int RowStep, int ColumnStep, class Number>
inline constexpr bool is_matrix<MatrixView<M, RowStep, ColumnStep, Number>> = true;

/// The product column by column: rows lie side by side, so that several are computed at a time.
template <class A, class B, class Product>
constexpr void multiply_columns(const A& a, const B& b, Product& product) noexcept {
    for (int j = 0; j < B::kColumns; ++j) {
        auto* const column = product.data() + Index{j} * A::kRows;
#pragma GCC unroll 8
        for (int i = 0; i < A::kRows; ++i) {
            column[i] = a.coeff(i, 0) * b.coeff(0, j);
        }
#pragma GCC unroll 8
        for (int k = 1; k < A::kColumns; ++k) {
#pragma GCC unroll 8
            for (int i = 0; i < A::kRows; ++i) {
                column[i] += a.coeff(i, k) * b.coeff(k, j);
            }
        }
    }
}

/// A row of one times a column of the other.
template <class A, class B>
requires(is_matrix<A>&& is_matrix<B>)
    [[nodiscard]] constexpr auto multiply_row(const A& a, const B& b, int i, int j) noexcept {
    if constexpr (A::kColumns == 3) {
        return a.coeff(i, 0) * b.coeff(0, j) +
               (a.coeff(i, 1) * b.coeff(1, j) + a.coeff(i, 2) * b.coeff(2, j));
    } else {
        auto sum = a.coeff(i, 0) * b.coeff(0, j);
#pragma GCC unroll 8
        for (int k = 1; k < A::kColumns; ++k) {
            sum += a.coeff(i, k) * b.coeff(k, j);
        }
        return sum;
    }
}

/// The product, whatever parts of matrices its factors are.
template <class A, class B>
requires(is_matrix<A>&& is_matrix<B>) [[nodiscard]] constexpr auto operator*(const A& a,
                                                                             const B& b) noexcept {
    static_assert(A::kColumns == B::kRows);
    Matrix<typename A::Scalar, A::kRows, B::kColumns> product;
    if constexpr (A::kRows > 3 && A::kRowStep == 1) {
        multiply_columns(a, b, product);
    } else {
#pragma GCC unroll 8
        for (int j = 0; j < B::kColumns; ++j) {
#pragma GCC unroll 8
            for (int i = 0; i < A::kRows; ++i) {
                product.coeffRef(i, j) = multiply_row(a, b, i, j);
            }
        }
    }
    return product;
}

/// Of a 3 x 3 matrix: what is left without row i and column j, with its sign.
template <class M>
[[nodiscard]] constexpr auto compute_cofactor(const M& m, int i, int j) noexcept {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    const int j1 = (j + 1) % 3;
    const int j2 = (j + 2) % 3;
    return m.coeff(i1, j1) * m.coeff(i2, j2) - m.coeff(i1, j2) * m.coeff(i2, j1);
}

/// A part of a matrix, or the whole with rows as columns: M is what it is a matrix of, Number is const where it is only read.
template <class M, int RowStep, int ColumnStep, class Number>
class MatrixView {
  public:
    using Scalar = typename M::Scalar;
    using Value = M;
    static constexpr int kRows = M::kRows;
    static constexpr int kColumns = M::kColumns;
    static constexpr int kSize = M::kSize;
    static constexpr int kRowStep = RowStep;
    static constexpr int kStep = kColumns == 1 ? RowStep : ColumnStep;

    constexpr explicit MatrixView(Number* at) noexcept : at_(at) {}
    constexpr MatrixView(const MatrixView&) noexcept = default;

    [[nodiscard]] constexpr Scalar coeff(Index i, Index j) const noexcept {
        return at_[i * RowStep + j * ColumnStep];
    }
    [[nodiscard]] constexpr Number& coeffRef(Index i, Index j) const noexcept {
        return at_[i * RowStep + j * ColumnStep];
    }
    [[nodiscard]] constexpr Number& operator()(Index i, Index j) const noexcept {
        assert(i >= 0 && i < kRows && j >= 0 && j < kColumns);
        return at_[i * RowStep + j * ColumnStep];
    }
    [[nodiscard]] constexpr Number& operator[](Index i) const noexcept {
        static_assert(kRows == 1 || kColumns == 1);
        assert(i >= 0 && i < kSize);
        return at_[i * kStep];
    }
    [[nodiscard]] constexpr Number& operator()(Index i) const noexcept { return (*this)[i]; }
    [[nodiscard]] constexpr Number& x() const noexcept { return at_[0]; }
    [[nodiscard]] constexpr Number& y() const noexcept { return at_[kStep]; }
    [[nodiscard]] constexpr Number& z() const noexcept { return at_[Index{2} * kStep]; }

    // NOLINTNEXTLINE(google-explicit-constructor): a part is used as what it is a part of.
    [[nodiscard]] constexpr operator M() const noexcept { return eval(); }
    [[nodiscard]] constexpr M eval() const noexcept {
        M whole;
#pragma GCC unroll 8
        for (int j = 0; j < kColumns; ++j) {
#pragma GCC unroll 8
            for (int i = 0; i < kRows; ++i) {
                whole.coeffRef(i, j) = coeff(i, j);
            }
        }
        return whole;
    }

    // What is assigned may overlap what it is assigned to: it is read first.
    // NOLINTBEGIN(bugprone-unhandled-self-assignment)
    constexpr const MatrixView& operator=(const M& m) const noexcept {
#pragma GCC unroll 8
        for (int j = 0; j < kColumns; ++j) {
#pragma GCC unroll 8
            for (int i = 0; i < kRows; ++i) {
                coeffRef(i, j) = m.coeff(i, j);
            }
        }
        return *this;
    }
    constexpr const MatrixView& operator=(const MatrixView& v) const noexcept {
        return *this = v.eval();
    }
    constexpr MatrixView& operator=(const MatrixView& v) noexcept {
        std::as_const(*this) = v.eval();
        return *this;
    }
    // NOLINTEND(bugprone-unhandled-self-assignment)
    constexpr const MatrixView& operator+=(const M& m) const noexcept {
        return *this = eval() + m;
    }
    constexpr const MatrixView& operator-=(const M& m) const noexcept {
        return *this = eval() - m;
    }
    constexpr const MatrixView& operator*=(Scalar s) const noexcept {
        return *this = eval() * s;
    }
    constexpr const MatrixView& operator/=(Scalar s) const noexcept {
        return *this = eval() / s;
    }
    constexpr void setZero() const noexcept {
        *this = M::Zero();
    }
    constexpr void setConstant(Scalar s) const noexcept {
        *this = M::Constant(s);
    }
    template <class First>
    constexpr auto operator<<(const First& first) const noexcept;

    template <int N>
    [[nodiscard]] constexpr auto head() const noexcept {
        return part<Matrix<Scalar, N, 1>>(0);
    }
    template <int N>
    [[nodiscard]] constexpr auto tail() const noexcept {
        return part<Matrix<Scalar, N, 1>>(Index{kSize - N} * kStep);
    }
    [[nodiscard]] constexpr auto transpose() const noexcept {
        return MatrixView<Matrix<Scalar, kColumns, kRows>, ColumnStep, RowStep, Number>(at_);
    }
    [[nodiscard]] constexpr auto diagonal() const noexcept {
        static_assert(kRows == kColumns);
        return MatrixView<Matrix<Scalar, kRows, 1>, RowStep + ColumnStep, ColumnStep, Number>(at_);
    }
    [[nodiscard]] constexpr Scalar dot(const M& m) const noexcept {
        return eval().dot(m);
    }
    [[nodiscard]] constexpr M cross(const M& m) const noexcept {
        return eval().cross(m);
    }
    [[nodiscard]] constexpr Scalar norm() const noexcept {
        return eval().norm();
    }
    [[nodiscard]] constexpr Scalar squaredNorm() const noexcept {
        return eval().squaredNorm();
    }
    [[nodiscard]] constexpr M normalized() const noexcept {
        return eval().normalized();
    }
    [[nodiscard]] constexpr Scalar sum() const noexcept {
        return eval().sum();
    }
    [[nodiscard]] constexpr Scalar minCoeff() const noexcept {
        return eval().minCoeff();
    }
    [[nodiscard]] constexpr Scalar maxCoeff() const noexcept {
        return eval().maxCoeff();
    }
    [[nodiscard]] constexpr M cwiseAbs() const noexcept {
        return eval().cwiseAbs();
    }
    [[nodiscard]] constexpr M cwiseAbs2() const noexcept {
        return eval().cwiseAbs2();
    }
    [[nodiscard]] constexpr M cwiseSqrt() const noexcept {
        return eval().cwiseSqrt();
    }
    [[nodiscard]] constexpr M cwiseMin(const M& m) const noexcept {
        return eval().cwiseMin(m);
    }
    [[nodiscard]] constexpr M cwiseMax(const M& m) const noexcept {
        return eval().cwiseMax(m);
    }
    [[nodiscard]] constexpr M cwiseProduct(const M& m) const noexcept {
        return eval().cwiseProduct(m);
    }
    [[nodiscard]] constexpr Scalar determinant() const noexcept {
        return eval().determinant();
    }
    [[nodiscard]] constexpr M inverse() const noexcept {
        return eval().inverse();
    }
    [[nodiscard]] constexpr Scalar trace() const noexcept {
        return eval().trace();
    }
    [[nodiscard]] constexpr bool allFinite() const noexcept {
        return eval().allFinite();
    }
    [[nodiscard]] constexpr bool isZero(Scalar most = M::kSlight) const noexcept {
        return eval().isZero(most);
    }
    [[nodiscard]] constexpr bool isApprox(const M& m, Scalar share = M::kSlight) const noexcept {
        return eval().isApprox(m, share);
    }
    template <class U>
    [[nodiscard]] constexpr auto cast() const noexcept {
        return eval().template cast<U>();
    }
    static constexpr Index rows() noexcept {
        return kRows;
    }
    static constexpr Index cols() noexcept {
        return kColumns;
    }
    static constexpr Index size() noexcept {
        return kSize;
    }

  private:
    template <class Part>
    [[nodiscard]] constexpr auto part(Index from) const noexcept {
        return MatrixView<Part, kStep, Part::kRows * kStep, Number>(at_ + from);
    }

    Number* at_;
};

/// Puts numbers or parts into a matrix, row by row from the left: m << a, b, c.
template <class M>
class Filling {
  public:
    constexpr explicit Filling(const M& m) noexcept : m_(m) {}
    constexpr Filling& operator,(typename M::Scalar s) noexcept {
        begin(1);
        m_.coeffRef(row_, column_++) = s;
        return *this;
    }
    template <class P>
    requires(is_matrix<P>) constexpr Filling& operator,(const P& part) noexcept {
        begin(P::kRows);
#pragma GCC unroll 8
        for (int j = 0; j < P::kColumns; ++j) {
#pragma GCC unroll 8
            for (int i = 0; i < P::kRows; ++i) {
                m_.coeffRef(row_ + i, column_ + j) = part.coeff(i, j);
            }
        }
        column_ += P::kColumns;
        return *this;
    }
    [[nodiscard]] constexpr typename M::Value finished() const noexcept {
        return m_;
    }

  private:
    constexpr void begin(int n_rows) noexcept {
        if (column_ == M::kColumns) {
            row_ += height_;
            column_ = 0;
        }
        height_ = n_rows;
    }

    M m_;
    int row_ = 0, column_ = 0, height_ = 0;
};

template <class M, int RowStep, int ColumnStep, class Number>
template <class First>
constexpr auto MatrixView<M, RowStep, ColumnStep, Number>::operator<<(
    const First& first) const noexcept {
    Filling<MatrixView> filling(*this);
    filling, first;
    return filling;
}

// NOLINTEND(readability-identifier-naming)

}  // namespace fulcrum
