// Vectors and matrices whose size is known when the program is compiled: values like a double, of the size of their numbers.
//
//   column after column in memory; an operator computes its result at once and returns it
//   a sum of three numbers is x + (y + z), one of four (x + y) + (z + w), one of more from the first to the last
// Nothing is fused or reordered, so the same source gives the same bits on every processor and with every compiler that keeps IEEE
// arithmetic. A part (`col`, `head`, `block`, …) of what can be written is a view that can be written; it lives no longer than its whole.
// Names are those of Eigen, so that a reader knows them. Dense systems of other sizes: haptics/math/dense.h.
//
// Thread: any. Cost: that of the arithmetic.
#pragma once

#include "haptics/math/matrix_parts.h"
#include "haptics/math/matrix_view.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace fulcrum {

// NOLINTBEGIN(readability-identifier-naming): names that readers of Eigen know.

template <class T, int R, int C>
class Matrix : public MatrixParts<T, R, C> {
  public:
    using Scalar = T;
    using Value = Matrix;
    static constexpr int kRows = R;
    static constexpr int kColumns = C;
    static constexpr int kSize = R * C;
    static constexpr int kRowStep = 1;
    static constexpr bool kIsVector = R == 1 || C == 1;
    static constexpr bool kIsSquare = R == C;
    /// Differences of this share are those of rounding.
    static constexpr T kSlight = sizeof(T) == 4 ? T(1.0e-5) : T(1.0e-12);

    /// Unset, as a double is.
    constexpr Matrix() noexcept {}  // NOLINT(cppcoreguidelines-pro-type-member-init)
    constexpr Matrix(const Matrix&) noexcept = default;
    // What is about to go, a part of something constant, say, can't be assigned to.
    constexpr Matrix& operator=(const Matrix&) & noexcept = default;
    constexpr Matrix(T x, T y) noexcept requires(kIsVector&& kSize == 2) : v_{x, y} {}
    constexpr Matrix(T x, T y, T z) noexcept requires(kIsVector&& kSize == 3) : v_{x, y, z} {}
    constexpr Matrix(T x, T y, T z, T w) noexcept requires(kIsVector&& kSize == 4)
        : v_{x, y, z, w} {}
    /// Of kSize numbers in memory, column after column.
    constexpr explicit Matrix(const T* numbers) noexcept {
        for (int i = 0; i < kSize; ++i) {
            v_[i] = numbers[i];
        }
    }

    [[nodiscard]] static constexpr Matrix Constant(T s) noexcept {
        return make([s](int) { return s; });
    }
    [[nodiscard]] static constexpr Matrix Zero() noexcept { return Constant(T(0)); }
    [[nodiscard]] static constexpr Matrix Ones() noexcept { return Constant(T(1)); }
    [[nodiscard]] static constexpr Matrix Identity() noexcept {
        return make([](int i) { return i % R == i / R ? T(1) : T(0); });
    }
    [[nodiscard]] static constexpr Matrix Unit(Index axis) noexcept {
        static_assert(kIsVector);
        return make([axis](int i) { return i == axis ? T(1) : T(0); });
    }
    [[nodiscard]] static constexpr Matrix UnitX() noexcept { return Unit(0); }
    [[nodiscard]] static constexpr Matrix UnitY() noexcept { return Unit(1); }
    [[nodiscard]] static constexpr Matrix UnitZ() noexcept { return Unit(2); }

    static constexpr Index rows() noexcept { return R; }
    static constexpr Index cols() noexcept { return C; }
    static constexpr Index size() noexcept { return kSize; }
    [[nodiscard]] constexpr T* data() noexcept { return v_; }
    [[nodiscard]] constexpr const T* data() const noexcept { return v_; }

    [[nodiscard]] constexpr T coeff(Index i, Index j = 0) const noexcept { return v_[i + j * R]; }
    [[nodiscard]] constexpr T& coeffRef(Index i, Index j = 0) noexcept { return v_[i + j * R]; }
    [[nodiscard]] constexpr T operator()(Index i, Index j) const noexcept {
        assert(i >= 0 && i < R && j >= 0 && j < C);
        return v_[i + j * R];
    }
    [[nodiscard]] constexpr T& operator()(Index i, Index j) noexcept {
        assert(i >= 0 && i < R && j >= 0 && j < C);
        return v_[i + j * R];
    }
    [[nodiscard]] constexpr const T& operator[](Index i) const noexcept {
        static_assert(kIsVector);
        assert(i >= 0 && i < kSize);
        return v_[i];
    }
    [[nodiscard]] constexpr T& operator[](Index i) noexcept {
        static_assert(kIsVector);
        assert(i >= 0 && i < kSize);
        return v_[i];
    }
    [[nodiscard]] constexpr const T& operator()(Index i) const noexcept { return (*this)[i]; }
    [[nodiscard]] constexpr T& operator()(Index i) noexcept { return (*this)[i]; }
    [[nodiscard]] constexpr const T& x() const noexcept { return v_[0]; }
    [[nodiscard]] constexpr T& x() noexcept { return v_[0]; }
    [[nodiscard]] constexpr const T& y() const noexcept { return v_[1]; }
    [[nodiscard]] constexpr T& y() noexcept { return v_[1]; }
    [[nodiscard]] constexpr const T& z() const noexcept { return v_[2]; }
    [[nodiscard]] constexpr T& z() noexcept { return v_[2]; }
    [[nodiscard]] constexpr const T& w() const noexcept { return v_[3]; }
    [[nodiscard]] constexpr T& w() noexcept { return v_[3]; }

    [[nodiscard]] constexpr T* begin() noexcept { return v_; }
    [[nodiscard]] constexpr T* end() noexcept { return v_ + kSize; }
    [[nodiscard]] constexpr const T* begin() const noexcept { return v_; }
    [[nodiscard]] constexpr const T* end() const noexcept { return v_ + kSize; }

    constexpr Matrix& setZero() noexcept { return *this = Zero(); }
    constexpr Matrix& setOnes() noexcept { return *this = Ones(); }
    constexpr Matrix& setConstant(T s) noexcept { return *this = Constant(s); }
    constexpr Matrix& setIdentity() noexcept { return *this = Identity(); }
    constexpr void fill(T s) noexcept { *this = Constant(s); }
    [[nodiscard]] constexpr const Matrix& eval() const noexcept { return *this; }
    template <class First>
    constexpr auto operator<<(const First& first) noexcept {
        return MatrixView<Matrix, 1, R, T>(v_) << first;
    }
    template <class U>
    [[nodiscard]] constexpr Matrix<U, R, C> cast() const noexcept {
        Matrix<U, R, C> other;
#pragma GCC unroll 8
        for (int i = 0; i < kSize; ++i) {
            other.data()[i] = static_cast<U>(v_[i]);
        }
        return other;
    }

    [[nodiscard]] friend constexpr Matrix operator+(const Matrix& a, const Matrix& b) noexcept {
        return make([&](int i) { return a.v_[i] + b.v_[i]; });
    }
    [[nodiscard]] friend constexpr Matrix operator-(const Matrix& a, const Matrix& b) noexcept {
        return make([&](int i) { return a.v_[i] - b.v_[i]; });
    }
    [[nodiscard]] friend constexpr Matrix operator-(const Matrix& a) noexcept {
        return make([&](int i) { return -a.v_[i]; });
    }
    [[nodiscard]] friend constexpr Matrix operator*(const Matrix& a, T s) noexcept {
        return make([&](int i) { return a.v_[i] * s; });
    }
    [[nodiscard]] friend constexpr Matrix operator*(T s, const Matrix& a) noexcept {
        return make([&](int i) { return s * a.v_[i]; });
    }
    [[nodiscard]] friend constexpr Matrix operator/(const Matrix& a, T s) noexcept {
        return make([&](int i) { return a.v_[i] / s; });
    }
    [[nodiscard]] friend constexpr bool operator==(const Matrix& a, const Matrix& b) noexcept {
        return all([&](int i) { return a.v_[i] == b.v_[i]; });
    }
    constexpr Matrix& operator+=(const Matrix& b) & noexcept {
        return *this = *this + b;
    }
    constexpr Matrix& operator-=(const Matrix& b) & noexcept {
        return *this = *this - b;
    }
    constexpr Matrix& operator*=(T s) & noexcept {
        return *this = *this * s;
    }
    constexpr Matrix& operator*=(const Matrix& b) & noexcept requires(kIsSquare&& kSize > 1) {
        return *this = *this * b;
    }
    constexpr Matrix& operator/=(T s) & noexcept {
        return *this = *this / s;
    }

    [[nodiscard]] constexpr T sum() const noexcept {
        if constexpr (kSize == 3) {
            return v_[0] + (v_[1] + v_[2]);
        } else if constexpr (kSize == 4) {
            return (v_[0] + v_[1]) + (v_[2] + v_[3]);
        } else {
            T sum = v_[0];
#pragma GCC unroll 8
            for (int i = 1; i < kSize; ++i) {
                sum += v_[i];
            }
            return sum;
        }
    }
    [[nodiscard]] constexpr T prod() const noexcept {
        if constexpr (kSize == 3) {
            return v_[0] * (v_[1] * v_[2]);
        } else {
            T product = v_[0];
            for (int i = 1; i < kSize; ++i) {
                product *= v_[i];
            }
            return product;
        }
    }
    [[nodiscard]] constexpr T dot(const Matrix& b) const noexcept {
        return cwiseProduct(b).sum();
    }
    [[nodiscard]] constexpr T squaredNorm() const noexcept {
        return dot(*this);
    }
    [[nodiscard]] T norm() const noexcept {
        return std::sqrt(squaredNorm());
    }
    /// Of length 1; zero and what is no number stay as they are.
    [[nodiscard]] Matrix normalized() const noexcept {
        const T square = squaredNorm();
        return square > T(0) ? *this / std::sqrt(square) : *this;
    }
    void normalize() noexcept {
        *this = normalized();
    }
    [[nodiscard]] constexpr Matrix cross(const Matrix& b) const noexcept {
        static_assert(kIsVector && kSize == 3);
        return {v_[1] * b.v_[2] - v_[2] * b.v_[1], v_[2] * b.v_[0] - v_[0] * b.v_[2],
                v_[0] * b.v_[1] - v_[1] * b.v_[0]};
    }
    /// A direction of length 1 across this one.
    [[nodiscard]] Matrix unitOrthogonal() const noexcept {
        static_assert(kIsVector && kSize == 3);
        const T small = kSlight * std::abs(v_[2]);
        if (std::abs(v_[0]) > small || std::abs(v_[1]) > small) {
            const T by = T(1) / std::sqrt(v_[0] * v_[0] + v_[1] * v_[1]);
            return {-v_[1] * by, v_[0] * by, T(0)};
        }
        const T by = T(1) / std::sqrt(v_[1] * v_[1] + v_[2] * v_[2]);
        return {T(0), -v_[2] * by, v_[1] * by};
    }
    [[nodiscard]] constexpr T trace() const noexcept {
        return this->diagonal().sum();
    }
    [[nodiscard]] constexpr T determinant() const noexcept {
        static_assert(kIsSquare && (R == 2 || R == 3));
        if constexpr (R == 2) {
            return v_[0] * v_[3] - v_[2] * v_[1];
        } else {
            return v_[0] * compute_cofactor(*this, 0, 0) + v_[1] * compute_cofactor(*this, 1, 0) +
                   v_[2] * compute_cofactor(*this, 2, 0);
        }
    }
    /// By cofactors; not finite where there is none.
    [[nodiscard]] constexpr Matrix inverse() const noexcept {
        static_assert(kIsSquare && R == 3);
        const Matrix<T, 3, 1> first(compute_cofactor(*this, 0, 0), compute_cofactor(*this, 1, 0),
                                    compute_cofactor(*this, 2, 0));
        const T by = T(1) / first.cwiseProduct(Matrix<T, 3, 1>(v_)).sum();
        Matrix inverse;
#pragma GCC unroll 8
        for (int i = 0; i < 3; ++i) {
            inverse.v_[3 * i] = first.data()[i] * by;
        }
#pragma GCC unroll 8
        for (int j = 1; j < 3; ++j) {
#pragma GCC unroll 8
            for (int i = 0; i < 3; ++i) {
                inverse.v_[j + 3 * i] = compute_cofactor(*this, i, j) * by;
            }
        }
        return inverse;
    }

    /// f of each.
    template <class F>
    [[nodiscard]] constexpr Matrix unaryExpr(const F& f) const noexcept {
        return make([&](int i) { return f(v_[i]); });
    }
    [[nodiscard]] constexpr Matrix cwiseProduct(const Matrix& b) const noexcept {
        return make([&](int i) { return v_[i] * b.v_[i]; });
    }
    [[nodiscard]] constexpr Matrix cwiseQuotient(const Matrix& b) const noexcept {
        return make([&](int i) { return v_[i] / b.v_[i]; });
    }
    [[nodiscard]] constexpr Matrix cwiseMin(const Matrix& b) const noexcept {
        return make([&](int i) { return b.v_[i] < v_[i] ? b.v_[i] : v_[i]; });
    }
    [[nodiscard]] constexpr Matrix cwiseMax(const Matrix& b) const noexcept {
        return make([&](int i) { return v_[i] < b.v_[i] ? b.v_[i] : v_[i]; });
    }
    [[nodiscard]] constexpr Matrix cwiseMin(T s) const noexcept {
        return cwiseMin(Constant(s));
    }
    [[nodiscard]] constexpr Matrix cwiseMax(T s) const noexcept {
        return cwiseMax(Constant(s));
    }
    [[nodiscard]] constexpr Matrix cwiseAbs() const noexcept {
        return make([&](int i) { return std::abs(v_[i]); });
    }
    [[nodiscard]] constexpr Matrix cwiseAbs2() const noexcept {
        return cwiseProduct(*this);
    }
    [[nodiscard]] Matrix cwiseSqrt() const noexcept {
        return make([&](int i) { return std::sqrt(v_[i]); });
    }
    [[nodiscard]] Matrix cwiseFloor() const noexcept {
        return make([&](int i) { return std::floor(v_[i]); });
    }
    /// To the nearest whole number, halves away from zero.
    [[nodiscard]] Matrix cwiseRound() const noexcept {
        return make([&](int i) { return std::round(v_[i]); });
    }
    [[nodiscard]] constexpr Matrix cwiseInverse() const noexcept {
        return make([&](int i) { return T(1) / v_[i]; });
    }
    [[nodiscard]] constexpr T minCoeff() const noexcept {
        T least = v_[0];
        for (int i = 1; i < kSize; ++i) {
            least = v_[i] < least ? v_[i] : least;
        }
        return least;
    }
    [[nodiscard]] constexpr T maxCoeff() const noexcept {
        T most = v_[0];
#pragma GCC unroll 8
        for (int i = 1; i < kSize; ++i) {
            most = most < v_[i] ? v_[i] : most;
        }
        return most;
    }
    /// And where the first of them stands.
    template <class I>
    constexpr T minCoeff(I* where) const noexcept {
        return -(-*this).maxCoeff(where);
    }
    template <class I>
    constexpr T maxCoeff(I* where) const noexcept {
        T most = v_[0];
        *where = 0;
#pragma GCC unroll 8
        for (int i = 1; i < kSize; ++i) {
            if (v_[i] > most) {
                most = v_[i];
                *where = static_cast<I>(i);
            }
        }
        return most;
    }
    [[nodiscard]] constexpr bool allFinite() const noexcept {
        // Only what is not finite is no number less itself.
        return all([&](int i) { return v_[i] - v_[i] == T(0); });
    }
    /// No number's magnitude is above `most`.
    [[nodiscard]] constexpr bool isZero(T most = kSlight) const noexcept {
        return all([&](int i) { return std::abs(v_[i]) <= most; });
    }
    /// The difference is no longer than this share of the shorter.
    [[nodiscard]] bool isApprox(const Matrix& b, T share = kSlight) const noexcept {
        const T shorter = std::min(squaredNorm(), b.squaredNorm());
        return (*this - b).squaredNorm() <= share * share * shorter;
    }
    /// Each number is at most, or below, its counterpart.
    [[nodiscard]] friend constexpr bool all_at_most(const Matrix& a, const Matrix& b) noexcept {
        return all([&](int i) { return a.v_[i] <= b.v_[i]; });
    }
    [[nodiscard]] friend constexpr bool all_below(const Matrix& a, const Matrix& b) noexcept {
        return all([&](int i) { return a.v_[i] < b.v_[i]; });
    }
    /// The matrix that is nothing but this diagonal.
    [[nodiscard]] constexpr Matrix<T, kSize, kSize> asDiagonal() const noexcept {
        static_assert(kIsVector);
        Matrix<T, kSize, kSize> m = Matrix<T, kSize, kSize>::Zero();
        m.diagonal() = *this;
        return m;
    }

  private:
    template <class F>
    [[nodiscard]] static constexpr Matrix make(const F& f) noexcept {
        Matrix m;
        if constexpr (kSize == 3) {
            m.v_[0] = f(0);
            m.v_[1] = f(1);
            m.v_[2] = f(2);
        } else if constexpr (kSize % 2 == 1) {
#pragma GCC unroll 16
            for (int i = 0; i < kSize; ++i) {
                m.v_[i] = f(i);
            }
        } else {
            // Two or four at a time.
            for (int i = 0; i < kSize; ++i) {
                m.v_[i] = f(i);
            }
        }
        return m;
    }
    template <class F>
    [[nodiscard]] static constexpr bool all(const F& f) noexcept {
        bool all = f(0);
#pragma GCC unroll 16
        for (int i = 1; i < kSize; ++i) {
            all = all && f(i);
        }
        return all;
    }
    T v_[static_cast<std::size_t>(kSize)];
};

// NOLINTEND(readability-identifier-naming)

}  // namespace fulcrum
