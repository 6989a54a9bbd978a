// Of all accelerations that contacts allow a rigid tool, the one nearest to what it would have without them (Gauss' principle of least
// constraint), and the force by which the contacts make the difference.
//
//   a_c = argmin 1/2 (a - a_u)^T M (a - a_u)   subject to   n_k . a_G + (r_k x n_k) . alpha >= b_k          k = 1..n
//   F   = M (a_c - a_u) = sum of lambda_k J_k,   lambda_k >= 0,   J_k = (n_k, r_k x n_k)
// a = (a_G, alpha) of the tool's centre of mass G; r_k from G to the contact, n_k out of the obstacle. With b_k <= 0 standing still is allowed, so
// there always is an answer. In y = L^T a, M = L L^T, it is the point of a polyhedron that is nearest to L^T a_u; the dual active set method goes
// there from a_u over points that are each nearest to a_u on the faces they lie on, so it never leaves what is optimal and ends after finitely
// many rounds, whether contacts are redundant or not: a normal that follows from those that act takes the place of one of them.
// Six contacts at most act at once. Those of the solve before are tried first.
// Normals that are differences over small gaps err by up to 1e-9. A row that is within 4e-9 (1 + sum |x_j|) of the sum x_j of rows that act follows
// from them, else walls that face each other would hold along themselves, by forces without end. Of walls that are so nearly alike the strictest
// holds; of such as face each other without room each is kept to that share of what is wanted; bounds missed by more contradict each other.
// Rows that take each other's place without end, for they err, are kept to 2e-6 of it.
//
// Thread: that of the solver. Cost: 12 multiplications a contact and round, some 300 a contact that begins or ceases to act; no allocation.
// Source: M. Ortega, S. Redon, S. Coquillart 2007, A six degree-of-freedom god-object method for haptic display of rigid bodies with surface
// properties, IEEE TVCG 13(3), section 4.2 and eq. (1), which projects by D. Wilhelmsen 1976, A nearest point algorithm for convex polyhedral cones,
// Math. Comput. 30; here D. Goldfarb, A. Idnani 1983, A numerically stable dual method for solving strictly convex quadratic programs, Math.
// Programming 27, section 3, which also takes bounds b_k other than 0. The test has Wilhelmsen's beside it.
#pragma once

#include "haptics/math/wrench_jacobian.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace fulcrum {

/// What the contacts make of an acceleration that is wanted.
struct LeastConstraint {
    Vector6 acceleration{
        Vector6::Zero()};  ///< of the centre of mass, m/s^2, and about it, rad/s^2; world frame
    Vector6 force{Vector6::Zero()};  ///< N and N m by all contacts
    int acting = 0;                  ///< contacts with a force
    int rounds = 0;                  ///< contacts that began or ceased to act
    bool exact =
        true;  ///< false: bounds contradict each other, or a number is none; then the acceleration is zero
};

class LeastConstraintSolver {
  public:
    explicit LeastConstraintSolver(std::size_t max_contacts);

    /// The tool's mass in kilograms and inertia about its centre of mass in kg m^2, world frame. False, and nothing changed, where they are not
    /// positive definite.
    bool set_inertia(double mass_kg, const Matrix3& inertia_W) noexcept;
    /// No contacts any more. Which acted is remembered: contacts told in the same order start where they ended.
    void clear() noexcept { n_ = 0; }
    /// A contact at `arm_W` from the centre of mass, its normal of length 1 out of the obstacle; `least` m/s^2 along it. False where there is no room,
    /// or a number is none.
    bool add(const Vector3& arm_W, const Vector3& normal_W, double least = 0.0) noexcept;
    [[nodiscard]] std::size_t size() const noexcept { return n_; }

    /// For an acceleration that is wanted.
    const LeastConstraint& solve(const Vector6& wanted) noexcept;
    [[nodiscard]] const LeastConstraint& last() const noexcept { return answer_; }
    /// Of the last solve: the force along the normal of the contact that was added as `k`-th, newtons; 0 for one that does not act.
    [[nodiscard]] double force_N(std::size_t k) const noexcept;
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return rows_.capacity() * (sizeof(Vector6) + 2 * sizeof(double));
    }

  private:
    static constexpr int kMost = 6;
    /// The contacts that act, and an orthonormal basis of their rows: N = Q R.
    struct Acting {
        int n = 0;
        std::array<std::size_t, kMost> which{};
        Matrix6 Q{Matrix6::Zero()};
        Matrix6 R{Matrix6::Zero()};
        Vector6 force{Vector6::Zero()};  // scaled as the rows are
    };

    [[nodiscard]] const Vector6& row(std::size_t k) const noexcept { return rows_[k]; }
    bool append(std::size_t k, double least_rest) noexcept;
    void drop(int place) noexcept;
    void start(const Vector6& wanted) noexcept;
    [[nodiscard]] Vector6 nearest(const Vector6& wanted, Vector6& force) const noexcept;
    [[nodiscard]] std::size_t find_worst(const Vector6& at, double tolerance) const noexcept;
    bool take(std::size_t k, double size, Vector6& at, double& error) noexcept;
    const LeastConstraint& give_up() noexcept;

    Matrix6 L_{Matrix6::Identity()};  // lower, M = L L^T; in blocks of mass and inertia
    double per_root_mass_ = 1.0;
    Matrix3 per_root_inertia_{Matrix3::Identity()};  // what is told is multiplied by L^-1
    std::size_t n_ = 0;
    std::vector<Vector6> rows_;   // L^-1 J_k^T, each of length 1
    std::vector<double> least_;   // scaled likewise
    std::vector<double> length_;  // by which they were
    Acting acting_{};
    LeastConstraint answer_{};
};

}  // namespace fulcrum
