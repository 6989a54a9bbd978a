// On which side of a plane a point lies, exactly.
//
//   orientation(a, b, c, d) = sign of ((b - a) x (c - a)) . (d - a)
// is +1 where (a, b, c) run counter-clockwise as seen from d, 0 when the four are coplanar. Rounded arithmetic decides
// when its error bound allows, otherwise sums of doubles without any rounding do. So the sign is a property of the
// four points alone, whatever the order they are given in: neighbours agree about their shared edge.
//
// Thread: any. Cost: 30 operations; some microseconds for points coplanar to within rounding.
// Source: J. R. Shewchuk 1997, Adaptive precision floating-point arithmetic and fast robust geometric predicates,
// Discrete & Computational Geometry 18(3): two-sum, two-product, expansion sums and the error bound of orient3d.
#pragma once

#include "haptics/math/spatial.h"

#include <cmath>

namespace fulcrum {

/// The rounded determinant |u v w| errs by at most this times the product of the three vectors' largest components:
/// (7 + 56 e) e with e = 2^-53 times a permanent of at most six such products, rounded up.
inline constexpr double kDeterminantError = 5.0e-15;

/// As `orientation`, by exact arithmetic alone.
[[nodiscard]] int orientation_exact(const Vector3& a, const Vector3& b, const Vector3& c,
                                    const Vector3& d) noexcept;

[[nodiscard]] inline double largest_component(const Vector3& v) noexcept {
    return v.cwiseAbs().maxCoeff();
}

/// -1, 0 or +1. Coordinates must be finite and below 1e60 in magnitude.
[[nodiscard]] inline int orientation(const Vector3& a, const Vector3& b, const Vector3& c,
                                     const Vector3& d) noexcept {
    const Vector3 u = b - a;
    const Vector3 v = c - a;
    const Vector3 w = d - a;
    const double determinant = u.cross(v).dot(w);
    const double error =
        kDeterminantError * largest_component(u) * largest_component(v) * largest_component(w);
    if (std::abs(determinant) > error) {
        return determinant > 0.0 ? 1 : -1;
    }
    return orientation_exact(a, b, c, d);
}

}  // namespace fulcrum
