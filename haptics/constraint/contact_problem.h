// What touches and what is joined, as one problem: which impulses keep bodies apart, hold friction and joints?
//
//   M (v - v_free) = sum_c J_c^T p_c                 of each body: what its momentum changes by
//   contact: u = J v - target, along (n, t1, t2)     how b moves over a at the point
//     p_n >= 0,   u_n + R p_n >= 0,   one of them zero
//     |p_t| <= mu p_n;   u_t + R p_t = 0 where it is less, else p_t = -mu p_n u_t / |u_t|
//   row:     least <= p <= most;   u + R p = 0 between them, >= 0 at `least`, <= 0 at `most`
// p acts on b along the axes and on a against them. mu is the static coefficient, and the dynamic one for what slips.
//
// Impacts and rest are one problem in velocities and impulses (Stewart & Trinkle; Anitescu & Potra): v_free is what the bodies
// would have at the end of the step without constraints, v + h M^-1 (forces), and p / h are the forces of the step. target_n
// is what the gap asks for: -gap/h while there is one (it may close, no more), depth times a rate to push apart what overlaps,
// -e u_n before in a round of impacts that bounce (impact.h). Baraff states rest in accelerations and forces: where nothing
// slides, give accelerations where the names say velocity, and impulses are forces. What slides drags against its velocity, not
// its acceleration, so there this form has to be stated in velocities. In accelerations the problem may also have no answer with
// friction (Painleve's rod) where an impulse within the step is one.
//
// Nobody owns memory but the problem: it is reserved at construction. A full one drops and counts. What the answer was last
// time goes in with each contact and row (`impulse`, `slides`): whoever keeps manifolds keeps them.
//
// Thread: the world loop, or one of its pool for an island. Cost: of adding, a copy.
// Source: D. Stewart, J. Trinkle 1996, An implicit time-stepping scheme for rigid body dynamics with inelastic collisions and
// Coulomb friction, Int. J. Numer. Methods Eng. 39. M. Anitescu, F. Potra 1997, Nonlinear Dynamics 14. D. Baraff 1994, Fast
// contact force computation for nonpenetrating rigid bodies, SIGGRAPH, sections 2 to 5.
#pragma once

#include "haptics/constraint/contact_constraint.h"

#include <span>
#include <vector>

namespace fulcrum {

/// How many of each there may be.
struct ContactCapacity {
    int bodies = 64;
    int contacts = 256;
    int rows = 64;
};

class ContactProblem {
  public:
    explicit ContactProblem(const ContactCapacity& capacity);

    /// Forgets all; capacity stays.
    void clear() noexcept;
    /// Whether last step's impulses were, in that step, those of the step before: then they hold nothing that was meant for that
    /// step alone, and may be taken again where they are within the tolerance. Not so after `clear`.
    void set_settled(bool settled) noexcept { settled_ = settled; }
    [[nodiscard]] bool is_settled() const noexcept { return settled_; }
    /// Whether a step's time counts for more than the answer where there are many contacts (contact_solver.h). Not so after `clear`.
    void set_bounded(bool bounded) noexcept { bounded_ = bounded; }
    [[nodiscard]] bool is_bounded() const noexcept { return bounded_; }
    /// The body's number. kGround where there is no room, where the body's numbers or their inverses are none, or `inertia_W` is
    /// not symmetric and positive definite; counted.
    int add_body(double mass_kg, const Matrix3& inertia_W, const Vector6& free_velocity_W) noexcept;
    /// False where there is no room, bodies are not there or the same, a number is none, or what a unit impulse moves is too
    /// little or too much for one; counted.
    bool add_contact(const ContactConstraint& contact) noexcept;
    bool add_row(const RowConstraint& row) noexcept;

    [[nodiscard]] std::span<ConstrainedBody> bodies() noexcept {
        return span_of(bodies_, n_bodies_);
    }
    [[nodiscard]] std::span<const ConstrainedBody> bodies() const noexcept {
        return {bodies_.data(), n_bodies_};
    }
    [[nodiscard]] std::span<ContactConstraint> contacts() noexcept {
        return span_of(contacts_, n_contacts_);
    }
    [[nodiscard]] std::span<const ContactConstraint> contacts() const noexcept {
        return {contacts_.data(), n_contacts_};
    }
    [[nodiscard]] std::span<RowConstraint> rows() noexcept { return span_of(rows_, n_rows_); }
    [[nodiscard]] std::span<const RowConstraint> rows() const noexcept {
        return {rows_.data(), n_rows_};
    }
    /// What was refused since the last `clear`.
    [[nodiscard]] int n_dropped() const noexcept { return n_dropped_; }
    [[nodiscard]] const ContactCapacity& capacity() const noexcept { return capacity_; }

  private:
    template <class T>
    static std::span<T> span_of(std::vector<T>& all, std::size_t n) noexcept {
        return {all.data(), n};
    }
    [[nodiscard]] bool is_pair(int body_a, int body_b) const noexcept;
    bool refuse() noexcept;

    ContactCapacity capacity_;
    std::vector<ConstrainedBody> bodies_;
    std::vector<ContactConstraint> contacts_;
    std::vector<RowConstraint> rows_;
    std::size_t n_bodies_ = 0;
    std::size_t n_contacts_ = 0;
    std::size_t n_rows_ = 0;
    int n_dropped_ = 0;
    bool settled_ = false;
    bool bounded_ = false;
};

/// Unit normal and two tangents, right-handed; the tangents turn evenly with the normal almost everywhere.
[[nodiscard]] Matrix3 make_contact_axes(const Vector3& normal_W) noexcept;

/// (m v.v + w.I w) / 2 of all bodies with these velocities, joules.
[[nodiscard]] double compute_kinetic_energy_J(const ContactProblem& problem) noexcept;

}  // namespace fulcrum
