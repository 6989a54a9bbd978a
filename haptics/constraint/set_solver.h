// Contact problems by guessing sets: which contacts push, stick and slip, one linear system a guess, until a guess holds.
//
// With y = u + R p, w a constraint's weight and t = p - y / w (what the natural map of complementarity.h projects):
//   t_n <= 0                  p = 0
//   else y_n = 0, and with    sticks: y_t = 0
//   |t_t| <= mu t_n
//   else                      slips: p_t = mu p_n d - k e (e . y),   d = t_t / |t_t|, e across it,
//                             k = a / (w (1 - a)), a = mu t_n / |t_t|: how the direction turns, of first order
//   pyramid: each axis by itself, |t_i| <= mu t_n: y_i = 0, else p_i = mu p_n sign t_i
//   row: t within its bounds: y = 0, else p the bound
// y = 0 stands for y + c (p - l) = 0, c = eps w, l the impulse of the guess before, brought into its set: a proximal step, whatever is
// redundant. So p = b - S u, and with H = M + sum J^T S J the velocities follow from one system of 6 x 6 blocks a body and a pair; where a
// guess is that before and nothing turns, H is kept.
// Impulses and velocities weigh alike in t, so sets do not flicker as those of a stiff energy do, and whole steps nearly always end: that
// is Newton's method for the natural map, without a search. Nothing falls from step to step, so where kMostIdle guesses gain
// nothing it ends without an answer, and what it was given stays: newton_solver.h goes on from there.
//
// Thread: that of the solver. Cost: of a guess, some 0.5 us a body of a stack with its contacts; no allocation.
// Source: P. Alart, A. Curnier 1991, A mixed formulation for frictional contact problems prone to Newton like solution methods, Comput.
// Methods Appl. Mech. Eng. 92; M. Hintermueller, K. Ito, K. Kunisch 2003, The primal-dual active set strategy as a semismooth Newton
// method, SIAM J. Optim. 13.
#pragma once

#include "haptics/constraint/block_system.h"
#include "haptics/constraint/contact_method.h"
#include "haptics/constraint/contact_motion.h"

#include <span>
#include <vector>

namespace fulcrum {

/// Guesses at most.
inline constexpr int kMostGuesses = 20;

class SetSolver {
  public:
    struct Answer {
        int n_guesses = 0;   ///< linear systems
        bool found = false;  ///< the problem has the impulses, within the tolerance
    };

    /// Of `settings` the friction's shape counts.
    SetSolver(const ContactSolverSettings& settings, const ContactCapacity& capacity);

    /// From the problem's impulses and `motion`, what they make of the velocities. `matrix` has the problem's pairs in order.
    /// Velocities are left as they come; without an answer the impulses are those that were.
    Answer solve(ContactProblem& problem, std::span<const double> friction, double tolerance,
                 int most_guesses, BlockSystem& matrix, BodyMotion& motion) noexcept;

  private:
    struct Contact {
        double friction = 0.0;
        double compliance = 0.0, stiffness = 0.0;   // c, 1 / (R + c)
        Vector3 u{Vector3::Zero()}, p{u}, rest{u};  // the last: b
        Matrix3 slope{Matrix3::Zero()};             // S
        ImpulseState state, built;                  // and when H was built
    };
    struct Row {
        double compliance = 0.0, stiffness = 0.0;
        double u = 0.0, p = 0.0, rest = 0.0;
        bool free = false;        // between its bounds
        int side = 0, built = 0;  // 0 there, else the sign of the bound; and when H was built
    };

    void prepare(const ContactProblem& problem, std::span<const double> friction) noexcept;
    void set_compliance(const ContactProblem& problem, double eps) noexcept;
    /// Impulses follow from velocities.
    void follow(const ContactProblem& problem, const BodyMotion& motion) noexcept;
    /// Sets of impulses and velocities as they are; returns the natural map.
    double guess(const ContactProblem& problem) noexcept;
    void guess_contact(double weight, double softness, const Vector3& t,
                       Contact& contact) const noexcept;
    void slip_on_cone(double weight, double softness, const Vector3& t,
                      Contact& contact) const noexcept;
    static void slip_on_pyramid(const Vector3& t, Contact& contact) noexcept;
    [[nodiscard]] bool has_built_sets() const noexcept;
    /// False where a pivot was lost.
    bool build(const ContactProblem& problem, BlockSystem& matrix) noexcept;
    void move(const ContactProblem& problem, const BlockSystem& matrix,
              BodyMotion& motion) noexcept;
    void keep(ContactProblem& problem) const noexcept;

    FrictionShape shape_;
    double eps_ = 0.0;
    double touching_m_per_s_ = 0.0;
    std::vector<Contact> contact_room_;
    std::vector<Row> row_room_;
    std::span<Contact> contacts_;  // of this problem
    std::span<Row> rows_;
    std::vector<Vector6> slope_;  // a vector a body
};

}  // namespace fulcrum
