// Contact problems in velocities: semismooth Newton on a convex energy, the bodies' matrix kept sparse.
//
// With c = eps w the compliance of a constraint within the step, D = 1 / (R + c), l its impulse so far and P the projection onto
// what it may do (friction_shape.h; least..most of a row), the velocities minimise
//   E(v) = (v - v_free)^T M (v - v_free) / 2 + sum |p|^2 / 2D,   p = P(D (c l - u - s n))
// a convex function with one smallest place, whatever is redundant. Its slope is g = M (v - v_free) - J^T p, and Newton's matrix
//   H = M + sum J^T D P' J                          one 6 x 6 block a body and one a pair: block_system.h
// The step d = -H^-1 g is taken whole where it changes no set, else as far as E falls along it: the root of its slope, found by
// Newton within a bracket. Where E is near its smallest, its slope a tenth of the natural map or less, l becomes p (method of
// multipliers with inexact minima), which ends when the natural map does: so eps costs no accuracy, only rounds. It is made
// smaller where rounds gain little.
//
// s makes of the convex law, where what slips also lifts by mu |y_t|, Coulomb's own: s = mu |y_t|, y = u + R p (de Saxce). It
// starts from the slip that last step's impulses leave, and follows the slip: then H has the slope of s too, is not symmetric,
// and a few whole steps are exact (where something was pressed and nothing slid, s is held at first, for little will begin to).
// With S = P' and the slope g of s by y, y' = 1 - R D S (1 + n s'), so
//   s' = g (1 - R D S) / (1 + R D g S n),   p' = -D S (1 + n s')
// Where they gain nothing, as where many contacts begin to slip, s is held, E made smallest, and s let follow
// from there; after a few attempts the answer for the last s held is taken, and counted as regularised: what slips lifts by
// mu times what its slip changed by, for a step.
//
// First of all last step's impulses are tried as they are: at rest they are the answer, and nothing is solved. Then sets are guessed
// from them (set_solver.h), which nearly always ends after a few systems; what is above is for what does not. Last step's impulses, or
// none at all, are also the answer where the method ends with a greater residual than theirs. Where impulses grow without end, as on what
// is squeezed, it ends with those before, and that is counted as regularised.
//
// Thread: that of the solver. Cost: `fulcrum bench contact-solvers`; of a linear solve, in proportion to bodies of a stack.
// Source: A. Castro, F. Permenter, X. Han 2022, An unconstrained convex formulation of compliant contact, IEEE Trans. Robotics 39
// (primal Newton, supernodal); M. Hestenes 1969, R. T. Rockafellar 1976 (multipliers as proximal steps); L. Qi, J. Sun 1993
// (semismooth Newton); G. de Saxce, Z.-Q. Feng 1998, The bipotential method, Math. Comput. Modelling 28; V. Acary, F. Cadoux,
// C. Lemarechal, J. Malick 2011, A formulation of the linear discrete Coulomb friction problem via convex optimization, ZAMM 91.
#pragma once

#include "haptics/constraint/block_system.h"
#include "haptics/constraint/contact_method.h"
#include "haptics/constraint/contact_motion.h"
#include "haptics/constraint/set_solver.h"

#include <span>
#include <vector>

namespace fulcrum {

class NewtonSolver final : public ContactMethodSolver {
  public:
    NewtonSolver(const ContactSolverSettings& settings, const ContactCapacity& capacity);
    SolveReport solve(ContactProblem& problem, std::span<const double> friction,
                      double tolerance) noexcept override;

  private:
    /// What is held while E is made smallest.
    struct Multiplier {
        Vector3 l{Vector3::Zero()};
        double shift = 0.0;  // s
    };
    struct Contact {
        double compliance = 0.0, stiffness = 0.0, softness = 0.0;  // c, D, R
        double friction = 0.0;
        Multiplier now, before;  // and as it was before s began to follow
        Vector3 u{Vector3::Zero()}, du{u}, q{u}, p{u}, started{u};  // the last: last step's impulse
        ImpulseState state, built;  // where p lies, and where it lay when H was built
    };
    struct Row {
        double compliance = 0.0, stiffness = 0.0;
        double l = 0.0, l_before = 0.0, u = 0.0, du = 0.0, p = 0.0, started = 0.0;
        bool free = false;        // between its bounds
        int side = 0, built = 0;  // 0 there, else the sign of the bound; and when H was built
    };
    /// How impulses and velocities fit.
    struct Fit {
        double residual = 0.0;  // natural map
        double defect = 0.0;    // of E's slope, as velocity
        double shift = 0.0;     // largest error of s
        double energy = 0.0;    // twice that of the defect
        double push = 0.0;      // largest of weights times impulses
    };

    void prepare(const ContactProblem& problem, std::span<const double> friction) noexcept;
    [[nodiscard]] bool find_order(const ContactProblem& problem) noexcept;
    void set_stiffness(const ContactProblem& problem, double eps) noexcept;
    void iterate(ContactProblem& problem, double tolerance, SolveReport& report) noexcept;
    /// Velocities follow from p; returns the residual.
    double move_to_impulses(ContactProblem& problem) noexcept;
    double measure(const ContactProblem& problem) noexcept;
    /// p follows from velocities.
    Fit evaluate(const ContactProblem& problem) noexcept;
    void evaluate_contact(const ContactConstraint& c, Contact& contact, Fit& fit) noexcept;
    /// mu |y_t|.
    [[nodiscard]] double find_lift(const Contact& contact) const noexcept {
        return compute_lift(settings_.friction_shape, contact.friction,
                            contact.u + contact.softness * contact.p);
    }
    void follow_slip(Contact& contact) const noexcept;
    void project(Contact& contact, double along) const noexcept;
    static void project(const RowConstraint& constraint, Row& row, double along) noexcept;
    [[nodiscard]] bool sticks(const ContactProblem& problem) const noexcept;
    void start_multipliers(const ContactProblem& problem) noexcept;
    [[nodiscard]] double take_least(ContactProblem& problem, double started, double found) noexcept;
    void update_multipliers() noexcept;
    void begin_attempt() noexcept;
    void end_attempt() noexcept;
    bool correct(const ContactProblem& problem, const Fit& fit, double tolerance) noexcept;
    void keep(ContactProblem& problem) const noexcept;
    bool guess_sets(ContactProblem& problem, std::span<const double> friction, double tolerance,
                    SolveReport& report) noexcept;

    // newton_step.cpp
    /// The shift of what slips follows its velocity.
    [[nodiscard]] bool follows(const Contact& contact) const noexcept {
        return coulomb_ && contact.state.pressed && contact.state.slips && contact.friction > 0.0;
    }
    [[nodiscard]] Matrix3 compute_slope_of(const Contact& contact) const noexcept;
    double step(const ContactProblem& problem, SolveReport& report) noexcept;
    void build(const ContactProblem& problem) noexcept;
    void add_contacts(const ContactProblem& problem) noexcept;
    void add_rows(const ContactProblem& problem) noexcept;
    [[nodiscard]] bool has_built_sets() const noexcept;
    void find_changes(const ContactProblem& problem) noexcept;
    double compute_slope(const ContactProblem& problem, double along) noexcept;
    [[nodiscard]] double compute_curvature() const noexcept;
    double search(const ContactProblem& problem) noexcept;

    ContactSolverSettings settings_;
    BodyMotion motion_;
    BlockSystem matrix_;
    SetSolver sets_;
    std::vector<Contact> contact_room_;
    std::vector<Row> row_room_;
    std::span<Contact> contacts_;  // of this problem
    std::span<Row> rows_;
    std::vector<Vector6> slope_;  // g, a vector a body; becomes -d
    BodyMotion step_;             // d as velocities
    BodyMotion before_;           // velocities before s began to follow
    std::size_t n_bodies_ = 0;
    double eps_ = 0.0;
    bool built_ = false;     // H fits the stiffness
    bool coulomb_ = false;   // s follows the slip
    bool given_up_ = false;  // what was found is as near as it comes
    int n_attempts_ = 0;     // to let it follow
    int n_idle_ = 0;         // steps without gain since it does
    double attempt_fits_ = 0.0;
    double residual_before_ = 0.0;  // when l was corrected last
    double pull_ = 0.0;             // d . M (v - v_free)
    double inertia_ = 0.0;          // d . M d
    double first_slope_ = 0.0;      // of E along d where the step begins, g . d
};

}  // namespace fulcrum
