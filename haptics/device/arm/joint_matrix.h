// Numbers for each joint of an arm: as many as it has, never on the heap.
//
// Thread: any; a value. Cost: that of the arithmetic.
#pragma once

#include "haptics/math/matrix.h"

#include <array>

namespace fulcrum {

// NOLINTBEGIN(readability-identifier-naming): names that readers of Eigen know.

inline constexpr int kMostJoints = 7;

/// A number for each joint, or for each motor. Two that meet in an operator have the same size.
class JointVector {
  public:
    JointVector() = default;
    /// Zero in each of `n`, 0 to kMostJoints.
    explicit JointVector(Index n) noexcept : n_(static_cast<int>(n)) {
        assert(n >= 0 && n <= kMostJoints);
    }
    [[nodiscard]] static JointVector Zero(Index n) noexcept { return JointVector(n); }

    [[nodiscard]] Index size() const noexcept { return n_; }
    [[nodiscard]] Index rows() const noexcept { return n_; }
    [[nodiscard]] Index cols() const noexcept { return 1; }
    /// What is new is zero.
    void resize(Index n) noexcept {
        assert(n >= 0 && n <= kMostJoints);
        for (int i = n_; i < n; ++i) {
            v_[i] = 0.0;
        }
        n_ = static_cast<int>(n);
    }
    [[nodiscard]] double operator()(Index i) const noexcept {
        assert(i >= 0 && i < n_);
        return v_[i];
    }
    [[nodiscard]] double& operator()(Index i) noexcept {
        assert(i >= 0 && i < n_);
        return v_[i];
    }
    [[nodiscard]] double operator[](Index i) const noexcept { return (*this)(i); }
    [[nodiscard]] double& operator[](Index i) noexcept { return (*this)(i); }
    [[nodiscard]] double coeff(Index i, Index = 0) const noexcept { return v_[i]; }
    [[nodiscard]] const double* data() const noexcept { return v_; }
    [[nodiscard]] double& coeffRef(Index i) noexcept { return v_[i]; }
    void setZero() noexcept { *this = JointVector(n_); }

    [[nodiscard]] friend JointVector operator+(JointVector a, const JointVector& b) noexcept {
        return a += b;
    }
    [[nodiscard]] friend JointVector operator-(JointVector a, const JointVector& b) noexcept {
        return a -= b;
    }
    [[nodiscard]] friend JointVector operator*(double s, JointVector a) noexcept { return a *= s; }
    [[nodiscard]] friend JointVector operator*(JointVector a, double s) noexcept { return a *= s; }
    JointVector& operator+=(const JointVector& b) noexcept {
        for (int i = 0; i < n_; ++i) {
            v_[i] += b.v_[i];
        }
        return *this;
    }
    JointVector& operator-=(const JointVector& b) noexcept {
        for (int i = 0; i < n_; ++i) {
            v_[i] -= b.v_[i];
        }
        return *this;
    }
    JointVector& operator*=(double s) noexcept {
        for (int i = 0; i < n_; ++i) {
            v_[i] *= s;
        }
        return *this;
    }
    [[nodiscard]] friend bool operator==(const JointVector& a, const JointVector& b) noexcept {
        bool same = a.n_ == b.n_;
        for (int i = 0; same && i < a.n_; ++i) {
            same = a.v_[i] == b.v_[i];
        }
        return same;
    }
    [[nodiscard]] double dot(const JointVector& b) const noexcept {
        double sum = 0.0;
        for (int i = 0; i < n_; ++i) {
            sum += v_[i] * b.v_[i];
        }
        return sum;
    }
    [[nodiscard]] double norm() const noexcept { return std::sqrt(dot(*this)); }
    /// Of none: 0.
    [[nodiscard]] double maxCoeff() const noexcept {
        double most = n_ > 0 ? v_[0] : 0.0;
        for (int i = 1; i < n_; ++i) {
            most = most < v_[i] ? v_[i] : most;
        }
        return most;
    }
    [[nodiscard]] JointVector cwiseAbs() const noexcept {
        JointVector all = *this;
        for (int i = 0; i < n_; ++i) {
            all.v_[i] = std::abs(v_[i]);
        }
        return all;
    }
    [[nodiscard]] bool allFinite() const noexcept {
        bool all = true;
        for (int i = 0; i < n_; ++i) {
            all = all && std::isfinite(v_[i]);
        }
        return all;
    }

  private:
    int n_ = 0;
    double v_[kMostJoints] = {};
};

/// Rows and columns for each joint, or for each motor.
class JointMatrix {
  public:
    JointMatrix() = default;
    /// Zero everywhere.
    JointMatrix(Index rows, Index cols) noexcept
        : rows_(static_cast<int>(rows)), cols_(static_cast<int>(cols)) {
        assert(rows >= 0 && rows <= kMostJoints && cols >= 0 && cols <= kMostJoints);
    }
    [[nodiscard]] static JointMatrix Zero(Index rows, Index cols) noexcept { return {rows, cols}; }
    [[nodiscard]] static JointMatrix Identity(Index rows, Index cols) noexcept {
        JointMatrix one(rows, cols);
        for (Index i = 0; i < rows && i < cols; ++i) {
            one.coeffRef(i, i) = 1.0;
        }
        return one;
    }

    [[nodiscard]] Index rows() const noexcept { return rows_; }
    [[nodiscard]] Index cols() const noexcept { return cols_; }
    [[nodiscard]] double coeff(Index i, Index j) const noexcept { return v_[i + j * kMostJoints]; }
    [[nodiscard]] double& coeffRef(Index i, Index j) noexcept { return v_[i + j * kMostJoints]; }
    [[nodiscard]] double operator()(Index i, Index j) const noexcept {
        assert(i >= 0 && i < rows_ && j >= 0 && j < cols_);
        return coeff(i, j);
    }
    [[nodiscard]] double& operator()(Index i, Index j) noexcept {
        assert(i >= 0 && i < rows_ && j >= 0 && j < cols_);
        return coeffRef(i, j);
    }
    [[nodiscard]] JointMatrix transpose() const noexcept {
        JointMatrix turned(cols_, rows_);
        for (int j = 0; j < cols_; ++j) {
            for (int i = 0; i < rows_; ++i) {
                turned.coeffRef(j, i) = coeff(i, j);
            }
        }
        return turned;
    }
    [[nodiscard]] bool allFinite() const noexcept {
        bool all = true;
        for (int j = 0; j < cols_; ++j) {
            for (int i = 0; i < rows_; ++i) {
                all = all && std::isfinite(coeff(i, j));
            }
        }
        return all;
    }

  private:
    int rows_ = 0;
    int cols_ = 0;
    double v_[kMostJoints * kMostJoints] = {};
};

/// A v, each row from its first number to its last. Of an arm that has all its joints the compiler knows how many.
[[nodiscard]] inline JointVector multiply(const JointMatrix& a, const JointVector& v) noexcept {
    JointVector product(a.rows());
    const auto add = [&](Index n_rows, Index n) {
        for (Index j = 0; j < n; ++j) {
            for (Index i = 0; i < n_rows; ++i) {
                product.coeffRef(i) += a.coeff(i, j) * v.coeff(j);
            }
        }
    };
    if (a.rows() == kMostJoints && v.size() == kMostJoints) {
        add(kMostJoints, kMostJoints);
    } else {
        add(a.rows(), v.size());
    }
    return product;
}

// NOLINTEND(readability-identifier-naming)

}  // namespace fulcrum
