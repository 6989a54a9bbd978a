// Contact problems one constraint after the other: projected Gauss-Seidel, in rounds.
//
//   normal     p_n = max(0, p_n - omega (u_n + R p_n) / (w_n + R))
//   tangents   p_t = the nearest within mu p_n of p_t - omega (u_t + R p_t) / (w_t + R)
//   row        p = p - omega (u + R p) / (w + R), between least and most
// w_n, w the constraint's own part of J M^-1 J^T, w_t the larger eigenvalue of its tangents; bodies move at once. Rounds go forwards and backwards in turn, so that a
// push passes through a stack either way. It starts from the last step's impulses and ends when a round changes no velocity by a
// tenth of the tolerance, or the rounds are spent. Errors fall slowly where many bodies lean on each other or heavy ones on light:
// that is its knob, and why it is not the default.
//
// Thread: that of the solver. Cost: some 0.04 us a contact and round.
// Source: F. Jourdan, P. Alart, M. Jean 1998, A Gauss-Seidel like algorithm to solve frictional contact problems, Comput. Methods
// Appl. Mech. Engrg. 155; E. Catto 2005, Iterative dynamics with temporal coherence, GDC.
#pragma once

#include "haptics/constraint/contact_motion.h"
#include "haptics/constraint/contact_solver.h"

#include <span>
#include <vector>

namespace fulcrum {

class IterativeSolver final : public ContactMethodSolver {
  public:
    IterativeSolver(const ContactSolverSettings& settings, const ContactCapacity& capacity);
    SolveReport solve(ContactProblem& problem, std::span<const double> friction,
                      double tolerance) noexcept override;

  private:
    struct Contact {
        Matrix3 turning_a{Matrix3::Zero()},
            turning_b{Matrix3::Zero()};           // spin that a unit impulse along each axis gives
        double inverse_a = 0.0, inverse_b = 0.0;  // 1/kg
        double inverse_normal = 0.0;              // 1 / (w_n + R)
        double inverse_tangent = 0.0;             // 1 / (w_t + R)
    };
    struct Row {
        Vector6 change_a{Vector6::Zero()},
            change_b{Vector6::Zero()};  // velocities that a unit impulse gives
        double inverse = 0.0;
    };
    void prepare(const ContactProblem& problem) noexcept;
    double relax(ContactConstraint& constraint, const Contact& contact, double friction) noexcept;
    double relax(RowConstraint& constraint, const Row& row) noexcept;
    double sweep(ContactProblem& problem, std::span<const double> friction,
                 bool backwards) noexcept;

    ContactSolverSettings settings_;
    BodyMotion motion_;
    std::vector<Contact> contacts_;
    std::vector<Row> rows_;
};

}  // namespace fulcrum
