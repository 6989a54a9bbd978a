// How much a linear step x <- A x grows in the long run: the length of A's longest eigenvalue, without eigenvalues.
//
//   rho(A) = lim |A^m|^(1/m),   m = 2^k:  A is squared k times, its length taken out each time
//   ln rho = sum of ln(length i) / 2^i,   i = 0 … k
// What is left after k squarings is ln(m^(n-1)) / m, the growth of a mode that is there n times and nearly the same: 3e-10 for n = 12
// at k = 40. Rounding of the first squaring counts most, as often as |A|^2 is above |A^2|: let the variables be of one size. Searching
// the eigenvalues instead knows those of such a mode to the n-th root of rounding, and may not end.
//
// Thread: load path, it allocates. Cost: 40 products. Errors: infinite where an entry is not finite.
// Source: I. Gelfand 1941, Normierte Ringe, Mat. Sbornik 9(51).
#pragma once

#include "haptics/math/matrix.h"

#include <cstddef>
#include <span>

namespace fulcrum {

/// Of a square matrix of n x n numbers, column after column; 0 of one whose power is nothing.
[[nodiscard]] double compute_spectral_radius(std::span<const double> A, std::size_t n);

template <int N>
[[nodiscard]] double compute_spectral_radius(const Matrix<double, N, N>& A) {
    return compute_spectral_radius(std::span(A.data(), std::size_t{N} * N), std::size_t{N});
}

}  // namespace fulcrum
