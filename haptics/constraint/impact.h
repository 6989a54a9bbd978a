// What arrives bounces: impacts as coupled sets of impulses, round after round, with friction, and never with a gain of energy.
//
//   a round   contacts that arrive faster than `least`:  u_n >= e times their arrival   (Newton's law, all of them at once)
//             contacts without restitution and joints:   as in the step, and they hold
//             contacts that bounce but do not arrive:    take no part
//   until none arrives. So in a row of balls the last one leaves and the others stand, and what lies on a table stays on it.
// A round without friction never gains energy: it changes by p_n (1 - e) u_n / 2 with u_n < 0 before. With friction, or where what
// does not bounce is pressed by what does, it can (Kane's puzzle). There the round without bounce, e = 0, is solved too, which never
// gains, for all its p . u are 0 or less after; and the impulses between the two are taken that keep the energy at most:
//   p = p_0 + part (p_e - p_0),   part the greatest in 0..1 with E(part) <= E before,   E a quadratic in it
// Friction's cones are convex, so these impulses lie in them.
// Loads are no impacts: they act in the step that follows, in which what arrives more slowly than `least` stops.
//
// Thread: that of the island. Cost: a round is one solve of the contact problem, two where friction would gain; at most kMostImpactRounds.
// Source: B. Smith, D. Kaufman, E. Vouga, R. Tamstorf, E. Grinspun 2012, Reflections on simultaneous impact, ACM Trans. Graph. 31(4)
// (rounds of what arrives); T. Kane, D. Levinson 1985, Dynamics: theory and applications, McGraw-Hill (the puzzle).
#pragma once

#include "haptics/constraint/contact_motion.h"
#include "haptics/constraint/contact_solver.h"

#include <span>

namespace fulcrum {

inline constexpr int kMostImpactRounds = 64;

struct ImpactReport {
    int n_rounds = 0;
    bool done = true;     ///< nothing arrives any more
    SolveReport solve{};  ///< of the worst round
};

class ImpactSolver {
  public:
    explicit ImpactSolver(const ContactCapacity& capacity);

    /// `velocities`: of the problem's bodies, before and after. Of `problem` masses, contacts, with their restitution, and rows count;
    /// a contact arrives where it approaches faster than `least_m_per_s` and than its target lets it. A problem beyond the capacity is
    /// left as it is.
    ImpactReport solve(const ContactProblem& problem, double least_m_per_s, ContactSolver& solver,
                       std::span<Vector6> velocities) noexcept;

  private:
    bool begin_round(const ContactProblem& problem, std::span<const Vector6> velocities,
                     double least_m_per_s) noexcept;
    void add_rows(const ContactProblem& problem, std::span<const Vector6> velocities) noexcept;
    SolveReport solve_round(ContactSolver& solver) noexcept;
    void hold_energy(double twice_before_J, ContactSolver& solver) noexcept;

    ContactCapacity capacity_;
    ContactProblem round_;
    BodyMotion bounced_;
};

}  // namespace fulcrum
