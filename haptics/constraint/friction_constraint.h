// Gauss' least constraint with friction: what contacts make of an acceleration, or of a way, that is wanted of a rigid tool, where they also hold
// along themselves.
//
//   M (a - a_u) = sum_k J_k^T f_k,   u_k = J_k a - target_k = (u_n, u_t)                                    k = 1..n
//   f_n >= 0,   u_n >= 0,   one of them zero
//   |f_t| <= mu_k f_n;   u_t = 0 where it is less, else f_t = -mu_k f_n u_t / |u_t|
// With mu = 0 that is least_constraint.h. In y = L^T a, M = L L^T, and with c_k a small compliance, l_k the force so far and g_k a bound of friction,
//   q = l - u / c,   f_n = max(q_n, 0),   f_t = q_t, but no longer than g         r(y) = y - y_u - sum J^T f = 0
// For bounds that are held, r is the slope of a convex function of six numbers: Newton's method with a search along each step finds its only zero,
// however many contacts are redundant. Then l becomes f (method of multipliers, so c costs no accuracy) and g becomes mu f_n. Before
// each such round Newton's whole steps are tried with g = mu f_n at every y, whose matrix is not symmetric: near the answer they are exact.
//
// Where that ends without an answer, as where walls jam the tool and there may be many or the rounds go in a circle, what is given is right but
// for the bounds: contacts push, keep their bounds along the normals, and drag against the slip. It gives no energy either, and `force` is the sum of
// what the contacts push with. Contacts by the thousand may leave no time to come near a balance: then the tool stays where it is, held by all
// that was wanted of it.
// Contacts that are redundant share the force nearly evenly, and together it is the same.
//
// Thread: that of the solver. Cost: `fulcrum bench god-surfaces`; no allocation after it was built.
// Source: M. Ortega, S. Redon, S. Coquillart 2007, A six degree-of-freedom god-object method for haptic display of rigid bodies with surface
// properties, IEEE TVCG 13(3), section 6 (friction); J. Haslinger 1983, Approximation of the Signorini problem with friction, Math. Methods Appl.
// Sci. 5 (bounds held); P. Alart, A. Curnier 1991, A mixed formulation for frictional contact problems prone to Newton like solution methods, Comput.
// Methods Appl. Mech. Eng. 92.
#pragma once

#include "haptics/constraint/least_constraint.h"

#include <vector>

namespace fulcrum {

class FrictionConstraintSolver {
  public:
    explicit FrictionConstraintSolver(std::size_t max_contacts);

    /// As LeastConstraintSolver::set_inertia.
    bool set_inertia(double mass_kg, const Matrix3& inertia_W) noexcept;
    /// No contacts any more. Forces are remembered: as many contacts told in the same order start where they ended.
    void clear() noexcept { n_ = 0; }
    /// A contact at `arm_W` from the centre of mass, its normal of length 1 out of the obstacle, `friction` from 0 on; the tool gets at least `least`
    /// along the normal, and where it is held it goes along the contact as `carried_W` does. False where there is no room, or a number is none.
    bool add(const Vector3& arm_W, const Vector3& normal_W, double least, double friction,
             const Vector3& carried_W = Vector3::Zero()) noexcept;
    [[nodiscard]] std::size_t size() const noexcept { return n_; }

    /// For what is wanted. `exact`: within kTolerance of the largest that is wanted or asked for.
    const LeastConstraint& solve(const Vector6& wanted) noexcept;
    [[nodiscard]] const LeastConstraint& last() const noexcept { return answer_; }
    /// Of the last solve: the force of the contact that was added as `k`-th, newtons.
    [[nodiscard]] Vector3 force_W(std::size_t k) const noexcept;
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return contacts_.capacity() * sizeof(Contact);
    }

    static constexpr double kTolerance = 1.0e-11;

  private:
    using Axes = Matrix<double, 6, 3>;
    struct Contact {
        Axes J{Axes::Zero()};  // L^-1 J^T, of the normal and two tangents
        Matrix3 axes_W{Matrix3::Identity()};
        Vector3 asked{Vector3::Zero()}, least{asked};  // along them, and over the size
        double friction = 0.0;
        double weight = 0.0;  // J J^T, a third of its trace
        double stiffness = 0.0;
        Vector3 l{Vector3::Zero()};  // over the size of the last solve, as all forces
        Vector3 f{Vector3::Zero()}, q{Vector3::Zero()};
        double bound = 0.0;  // g
    };
    void prepare(double size) noexcept;
    // Sets q and f; with bounds that follow or that are held.
    Vector6 find_defect(const Vector6& y, bool follows) noexcept;
    [[nodiscard]] Matrix6 find_slope(bool follows) const noexcept;
    bool follow(Vector6& y) noexcept;
    double hold(Vector6& y, double enough) noexcept;
    struct Miss {
        double way = 0.0;    // along contacts that hold; no number where a force is none
        double bound = 0.0;  // of friction
        [[nodiscard]] double most() const noexcept { return way <= bound ? bound : way; }
    };
    void forget() noexcept;
    void stay() noexcept;
    [[nodiscard]] bool has_time() const noexcept;
    [[nodiscard]] Vector6 sum_forces() const noexcept;  // over the size, in y
    // How far it is from an answer; the next round's forces and bounds.
    Miss correct(double share) noexcept;
    [[nodiscard]] bool iterate(Vector6& y) noexcept;

    Matrix6 L_{Matrix6::Identity()};
    double per_root_mass_ = 1.0;
    Matrix3 per_root_inertia_{Matrix3::Identity()};
    std::size_t n_ = 0;
    std::size_t n_remembered_ = 0;
    std::size_t n_looks_ = 0;  // at a contact, of this solve
    double size_ = 1.0;
    Vector6 wanted_{Vector6::Zero()};  // y_u
    Vector6 last_{Vector6::Zero()};    // the last answer
    std::vector<Contact> contacts_;
    LeastConstraint answer_{};
};

}  // namespace fulcrum
