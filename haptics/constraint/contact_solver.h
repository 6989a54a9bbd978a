// Solves a contact problem, by one of three methods chosen by name, behind one call.
//
//   newton     in velocities: minimises the energy that impulses cost by semismooth Newton steps with the bodies' sparse matrix,
//              as exact as asked; at rest the last step's impulses are checked and found right (newton_solver.h)
//   dantzig    in impulses: one row after the other is driven to where it fits, those before it kept so by pivoting
//              (dantzig_solver.h); exact, friction by axes; cost grows fast where many contacts change
//   iterative  in impulses: contact after contact, many rounds (iterative_solver.h); as near as its rounds allow
// mu of a contact is its static coefficient, or the dynamic one if it slid. Where the answer slips at the static bound, the
// contact slides from now on: the problem is solved once more with the dynamic coefficient there. What stuck within the
// dynamic bound is held by the static one from the next step on.
//
// Where Newton ends outside the tolerance, as in a house of cards that stands by friction alone, and the problem has kMostPivotRows or
// less, pivoting solves it from the last step's impulses, and what is nearer is taken: that is counted, and friction there is a pyramid.
// Where a method ends far from an answer (kPoor of its scale: an impact too hard for its iterations, a body squeezed from both
// sides), that is counted as regularised, and rounds contact after contact from the last step's impulses, or from what pivoting
// left, are tried instead; what is nearer is taken.
//
// A problem that may be answered by bounded work (`set_bounded`) and has more contacts than `most_exact_contacts` gets kBoundedRounds
// rounds from last step's impulses alone, so that a step keeps its time and errors go within the next steps. What such rounds leave gives
// no energy: with u_0 and u the velocities before and after, impulses count by the greatest share s in 0..1 with
//   s p.u_0 + s^2 p.(u - u_0) / 2 <= 0     their work against what surfaces and rows ask for
// and that is counted as bounded, and as not converged.
//
// Answers are finite whatever comes in. What has none, is redundant or would take too long is answered as nearly as it can be:
// `converged` and `residual` say so, and what had to be regularised is counted.
//
// Thread: that of the island; each thread has its own solver. Cost: `fulcrum bench contact-solvers`; no allocation.
// Source: A. Barrow, W. Harwin 2006, A dynamic virtual environment for haptic interaction, section 5; the methods' own headers.
#pragma once

#include "haptics/constraint/contact_method.h"
#include "haptics/constraint/contact_motion.h"
#include "haptics/constraint/contact_problem.h"

#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

/// Of contacts that are too many.
inline constexpr int kBoundedRounds = 12;

/// Three a contact and one a row: more are not solved by pivoting in Newton's place.
inline constexpr int kMostPivotRows = 200;

class ContactSolver {
  public:
    /// Settings are those that `validate` accepted. Reserves what problems of that capacity need.
    ContactSolver(const ContactSolverSettings& settings, const ContactCapacity& capacity);

    /// Fills in impulses, sliding and velocities. A problem larger than the capacity is left as it is and not converged.
    SolveReport solve(ContactProblem& problem) noexcept;

    [[nodiscard]] const ContactSolverSettings& settings() const noexcept { return settings_; }
    /// What `residual_m_per_s` was taken with: the coefficient of each contact of the last problem.
    [[nodiscard]] std::span<const double> friction() const noexcept { return friction_; }

  private:
    SolveReport solve_once(ContactProblem& problem, std::span<const double> friction,
                           double tolerance) noexcept;
    SolveReport solve_bounded(ContactProblem& problem, std::span<const double> friction,
                              double tolerance) noexcept;
    void hold_energy(ContactProblem& problem, std::span<const double> friction,
                     SolveReport& report) noexcept;
    [[nodiscard]] bool is_bounded(const ContactProblem& problem) const noexcept {
        return bounded_ && problem.is_bounded() &&
               problem.contacts().size() > static_cast<std::size_t>(settings_.most_exact_contacts);
    }
    bool pivot(ContactProblem& problem, std::span<const double> friction, double tolerance,
               SolveReport& report) noexcept;
    void exchange_impulses(ContactProblem& problem) noexcept;
    bool note_sliding(ContactProblem& problem, double uncertain_m_per_s, bool may_change) noexcept;
    ContactSolverSettings settings_;
    ContactCapacity capacity_;
    std::unique_ptr<ContactMethodSolver> method_;
    std::unique_ptr<ContactMethodSolver> pivots_;   // where Newton ends outside the tolerance
    std::unique_ptr<ContactMethodSolver> rounds_;   // where that ends far from an answer
    std::unique_ptr<ContactMethodSolver> bounded_;  // where contacts are too many
    BodyMotion motion_;
    std::vector<Vector3> kept_contacts_;  // impulses put aside
    std::vector<double> kept_rows_;
    std::vector<double> friction_;
};

}  // namespace fulcrum
