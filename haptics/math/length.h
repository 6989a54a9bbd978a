// A vector's length and direction, right for numbers of any size and the same to the last bit wherever the vector lies.
//
//   |v| = s sqrt(sum of (v_i / s)^2)      s = 1, or the largest |v_i| where the squares would leave the range of double
//
// Thread: any. Cost: a square root and a comparison; a division more at the ends of the range.
#pragma once

#include "haptics/math/spatial.h"

#include <cmath>

namespace fulcrum {

namespace length_details {

// Between them no square has lost a digit that counts, nor overflowed.
inline constexpr double kLeastSquare = 1.0e-280;
inline constexpr double kMostSquare = 1.0e280;

inline bool is_plain(double square) noexcept {
    return square >= kLeastSquare && square <= kMostSquare;
}

// At the ends of the range; apart, so that the rest is small enough to stand where it is needed.
template <int N>
[[gnu::noinline, gnu::cold]] double scale_length(const Matrix<double, N, 1>& v,
                                                 double square) noexcept {
    const double largest = std::isnan(square) ? square : v.cwiseAbs().maxCoeff();
    return largest > 0.0 && std::isfinite(largest) ? largest * (v / largest).norm() : largest;
}

}  // namespace length_details

/// The Euclidean length, in the unit of `v`; not a number where a component is none, infinite where one is.
template <int N>
[[nodiscard]] inline double compute_length(const Matrix<double, N, 1>& v) noexcept {
    const double square = v.squaredNorm();
    return length_details::is_plain(square) ? std::sqrt(square)
                                            : length_details::scale_length(v, square);
}

/// `v`, or where it is longer than `most` its direction with that length.
template <int N>
[[nodiscard]] Matrix<double, N, 1> shorten(const Matrix<double, N, 1>& v, double most) noexcept {
    const double length = v.norm();
    return length > most ? Matrix<double, N, 1>(v * (most / length)) : v;
}

/// `v` no longer than `most`, of numbers of any size; 0: as long as it is.
template <int N>
[[nodiscard]] Matrix<double, N, 1> limit_length(const Matrix<double, N, 1>& v,
                                                double most) noexcept {
    const double length = compute_length(v);
    return most > 0.0 && length > most ? Matrix<double, N, 1>(v * (most / length)) : v;
}

/// Of length 1, to rounding; a vector without length or with an infinite one is given back as it is.
template <int N>
[[nodiscard]] Matrix<double, N, 1> compute_direction(const Matrix<double, N, 1>& v) noexcept {
    const double square = v.squaredNorm();
    if (length_details::is_plain(square)) {
        return v / std::sqrt(square);
    }
    const double largest = std::isnan(square) ? square : v.cwiseAbs().maxCoeff();
    return largest > 0.0 && std::isfinite(largest) ? (v / largest).normalized() : v;
}

}  // namespace fulcrum
