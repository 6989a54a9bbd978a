// The point of a polyhedral cone that is nearest to another point, in 64 bits of mantissa: what a solver of its own is compared with.
//
//   minimise |sum u_k g_k - v|,  u >= 0:  a generator that lies most towards what is left joins those in use; on the way to the nearest point of their
//   span a coefficient that would fall below 0 leaves them
// Source: D. Wilhelmsen 1976, A nearest point algorithm for convex polyhedral cones and applications to positive linear approximation, Math. Comput.
// 30; the same rounds as C. Lawson, R. Hanson 1974, Solving least squares problems, chapter 23 (NNLS).
#pragma once

#include "haptics/math/plain_eigen.h"

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

namespace fulcrum::wilhelmsen {

using Real = long double;
using Vector = Eigen::Matrix<Real, 6, 1>;

/// The point nearest to `v` that a sum of `generators` with coefficients of at least 0 gives.
inline Vector nearest_in_cone(const std::vector<Vector>& generators, const Vector& v) {
    std::vector<std::size_t> used;
    std::vector<Real> u;
    Vector p = Vector::Zero();
    const Real tolerance = 1.0e-17L * (v.norm() + 1.0e-300L);
    for (int round = 0; round < 10'000; ++round) {
        std::size_t best = generators.size();
        Real most = tolerance;
        for (std::size_t k = 0; k < generators.size(); ++k) {
            const Real towards = generators[k].dot(v - p) / generators[k].norm();
            bool is_used = false;
            for (const std::size_t other : used) {
                is_used = is_used || other == k;
            }
            if (!is_used && towards > most) {
                most = towards;
                best = k;
            }
        }
        if (best == generators.size()) {
            return p;
        }
        used.push_back(best);
        u.push_back(0.0L);
        while (true) {
            Eigen::Matrix<Real, 6, Eigen::Dynamic> N(6, used.size());
            for (std::size_t i = 0; i < used.size(); ++i) {
                N.col(static_cast<Eigen::Index>(i)) = generators[used[i]];
            }
            const Eigen::Matrix<Real, Eigen::Dynamic, 1> wanted =
                N.completeOrthogonalDecomposition().solve(v);
            Real share = 1.0L;
            std::size_t leaves = used.size();
            for (std::size_t i = 0; i < used.size(); ++i) {
                const Real to = wanted[static_cast<Eigen::Index>(i)];
                if (to <= 0.0L && u[i] / (u[i] - to) < share) {
                    share = u[i] / (u[i] - to);
                    leaves = i;
                }
            }
            for (std::size_t i = 0; i < used.size(); ++i) {
                u[i] += share * (wanted[static_cast<Eigen::Index>(i)] - u[i]);
            }
            if (leaves == used.size()) {
                p = N * wanted;
                break;
            }
            used.erase(used.begin() + static_cast<std::ptrdiff_t>(leaves));
            u.erase(u.begin() + static_cast<std::ptrdiff_t>(leaves));
        }
    }
    return p;
}

}  // namespace fulcrum::wilhelmsen
