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

#include "haptics/constraint/contact_method.h"
#include "haptics/constraint/contact_motion.h"

#include <span>
#include <vector>

namespace fulcrum {

class IterativeSolver final : public ContactMethodSolver {
  public:
    IterativeSolver(const ContactSolverSettings& settings, const ContactCapacity& capacity);
    SolveReport solve(ContactProblem& problem, std::span<const double> friction,
                      double tolerance) noexcept override;

  private:
    /// All that a round asks for, in one piece.
    struct Contact {
        Matrix3 axes_W;
        Matrix3 lever_a, lever_b;  // columns r x e of each axis e
        Matrix3 turning_a,
            turning_b;  // I^-1 (r x e): how fast a body turns by a unit impulse along each axis
        Vector3 target, p;
        double inverse_a{}, inverse_b{};             // masses
        double inverse_normal{}, inverse_tangent{};  // of weights
        double softness{}, friction{};
        int body_a{}, body_b{};
    };
    struct Row {
        Vector6 change_a{Vector6::Zero()},
            change_b{Vector6::Zero()};  // velocities that a unit impulse gives
        double inverse = 0.0;
    };
    void prepare(const ContactProblem& problem, std::span<const double> friction) noexcept;
    void prepare_rows(const ContactProblem& problem) noexcept;
    double relax(Contact& contact) noexcept;
    double relax(RowConstraint& constraint, const Row& row) noexcept;
    double sweep(ContactProblem& problem, bool backwards) noexcept;

    ContactSolverSettings settings_;
    BodyMotion motion_;
    std::vector<Contact> contact_room_;
    std::span<Contact> contacts_;  // of this problem
    std::vector<Row> rows_;
};

}  // namespace fulcrum
