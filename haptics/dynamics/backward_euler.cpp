// Backward Euler of integrator.h as six equations in u = (v', w'):
//
//   r_v = m (v' - v) - h F(x', q', v', w')            x' = x + h v'
//   r_w = L(q', w') - L - h tau(x', q', v', w')       q' = exp(h w') q,  L(q', w') = I' w',  I' = R' I R'^T
// Newton's matrix. A change dw of w' turns the body by dtheta = A dw, A = h J_l(h w'); and with it
//   dI' w' = dtheta x L' - I' (dtheta x w'),  so  dL = I' dw + (I' [w'] - [L']) A dw
//   dr_v = m dv - h (F_x h dv + F_theta A dw + F_v dv + F_w dw),  dr_w = dL - h (tau_x h dv + ...)
// The first guess is the old velocity, so loads are linearised where that leads; but where one solve is all, at the old pose and at
// rest, as Otaduy & Lin do: which contacts hold is told by where the body is, not by where its speed would take it. From there one
// solve may take a contact to and fro for ever. When a step of Newton has made the residual longer, a contact opened or
// closed on the way: half that step is tried. The first
// guess is never the answer, however little it leaves over: a load below the tolerance would be lost at every step for ever.
// Where the loads cannot tell two places apart the residual stays at their rounding: a whole step of Newton no longer than that
// which makes it no shorter is the last one, and the second which does not halve it. A halved step says nothing of the kind, nor
// does one that meets something new.
#include "haptics/dynamics/integrator.h"
#include "haptics/math/dense.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

struct Step {
    const Inertia& inertia;
    const Load& load;
    double end_s;
    double dt_s;
    const RigidState& start;
    Vector3 start_angular_momentum;
};

// The equations at one guess.
struct Guess {
    Vector6 residual;
    Matrix6 matrix{Matrix6::Zero()};
    double size = 0.0;  // of the residual, in tolerances
};

// The matrix takes the load's derivatives, which may cost many times the load itself.
enum class Wanted : std::uint8_t { residual, matrix_too, matrix_from_rest };

Twist add(const Twist& twist, const Vector6& change) noexcept {
    return {twist.linear + change.head<3>(), twist.angular + change.tail<3>()};
}

RigidState compute_state(const Step& step, const Twist& velocity) noexcept {
    return {{step.start.pose_W.position + step.dt_s * velocity.linear,
             compute_exp(step.dt_s * velocity.angular) * step.start.pose_W.orientation},
            velocity};
}

// The loads at the old pose and at rest, and from there on along their derivatives.
void add_wrench_from_rest(const Step& step, const Twist& velocity, Wrench& wrench,
                          WrenchJacobian& jacobian) noexcept {
    step.load.add_linearised_wrench({step.start.pose_W, {}}, step.end_s, wrench, jacobian);
    Vector6 speed;
    speed << velocity.linear, velocity.angular;
    const Vector6 change = (step.dt_s * jacobian.pose + jacobian.velocity) * speed;
    wrench.force += change.head<3>();
    wrench.torque += change.tail<3>();
}

Guess evaluate(const Step& step, const IntegratorSettings& settings, const Twist& velocity,
               Wanted wanted) noexcept {
    const RigidState state = compute_state(step, velocity);
    const double h = step.dt_s;
    const double mass_kg = step.inertia.mass_kg;
    Wrench wrench;
    WrenchJacobian jacobian;
    if (wanted == Wanted::residual) {
        step.load.add_wrench(state, step.end_s, wrench);
    } else if (wanted == Wanted::matrix_from_rest) {
        add_wrench_from_rest(step, velocity, wrench, jacobian);
    } else {
        step.load.add_linearised_wrench(state, step.end_s, wrench, jacobian);
    }
    // The residual.
    const Matrix3 inertia_W = compute_inertia_W(step.inertia, state.pose_W.orientation);
    const Vector3 momentum = inertia_W * velocity.angular;
    Guess guess;
    guess.residual.head<3>() =
        mass_kg * (velocity.linear - step.start.velocity_W.linear) - h * wrench.force;
    guess.residual.tail<3>() = momentum - step.start_angular_momentum - h * wrench.torque;
    guess.size =
        std::max(guess.residual.head<3>().norm() / (mass_kg * settings.newton_tolerance_m_per_s),
                 guess.residual.tail<3>().norm() /
                     (step.inertia.moments_kg_m2.minCoeff() * settings.newton_tolerance_rad_per_s));
    if (wanted == Wanted::residual) {
        return guess;
    }
    // Newton's matrix.
    const Matrix3 turn_by_spin = h * compute_left_jacobian(h * velocity.angular);
    guess.matrix = -h * jacobian.velocity;
    guess.matrix.leftCols<3>() -= h * h * jacobian.pose.leftCols<3>();
    guess.matrix.rightCols<3>() -= h * jacobian.pose.rightCols<3>() * turn_by_spin;
    guess.matrix.topLeftCorner<3, 3>().diagonal() += Vector3::Constant(mass_kg);
    guess.matrix.bottomRightCorner<3, 3>() +=
        inertia_W +
        (inertia_W * compute_skew(velocity.angular) - compute_skew(momentum)) * turn_by_spin;
    return guess;
}

// Solves matrix * x = -residual; rows and columns are scaled by the masses first, so that a kilogram and a kilogram square
// metre compare. Singular where a pivot is lost in rounding.
StepStatus solve(const Inertia& inertia, const Guess& guess, Vector6& change) noexcept {
    if (!guess.matrix.allFinite()) {
        return StepStatus::not_finite;
    }
    const double turn = 1.0 / std::sqrt(inertia.moments_kg_m2.minCoeff());
    const double shift = 1.0 / std::sqrt(inertia.mass_kg);
    Vector6 scale;
    scale << Vector3::Constant(shift), Vector3::Constant(turn);
    const Matrix6 scaled = guess.matrix.cwiseProduct(scale * scale.transpose());
    if (!scaled.allFinite()) {
        return StepStatus::singular;
    }
    Vector6 pivots;
    const Vector6 solved = solve_lu(scaled, scale.cwiseProduct(guess.residual), &pivots);
    pivots = pivots.cwiseAbs();
    constexpr double kLost = 1.0e-14;  // of the largest pivot: nothing but rounding
    if (!(pivots.minCoeff() > kLost * pivots.maxCoeff())) {
        return StepStatus::singular;
    }
    change = -scale.cwiseProduct(solved);
    return change.allFinite() ? StepStatus::done : StepStatus::singular;
}

// One linear solve is a method of its own, taken as it comes; of more, what the last one led to is tried as well.
int find_last_look(const IntegratorSettings& settings) noexcept {
    return settings.newton_iterations > 1 ? settings.newton_iterations : 0;
}

// What look `i` has to know: the first one solves; a later one may show that no more is needed.
Wanted find_wanted(int i, int last) noexcept {
    if (i > 0) {
        return Wanted::residual;
    }
    return last > 0 ? Wanted::matrix_too : Wanted::matrix_from_rest;
}

// Whether a whole step of Newton by `change`, from a residual of `before` to one of `after`, is lost in the loads' rounding. Steps
// that go on a little are none too many: a tool that is let go gets away from what brakes by such. `n_slow` counts them.
bool is_lost(const IntegratorSettings& settings, double dt_s, bool is_whole, const Vector6& change,
             double before, double after, int& n_slow) noexcept {
    constexpr double kHelps = 0.5;
    constexpr double kMeetsSomething = 10.0;
    constexpr int kMostSlow = 1;
    if (!is_whole || dt_s * change.head<3>().norm() > settings.least_way_m ||
        dt_s * change.tail<3>().norm() > settings.least_turn_rad) {
        return false;
    }
    if (!(after > kHelps * before && after < kMeetsSomething * before)) {
        return false;
    }
    return after > before || ++n_slow > kMostSlow;
}

// The last change of base, where it is not the best guess already: kept behind the first guess, which is no answer.
void forget_worse(bool is_best, int n_changes, Vector6& change) noexcept {
    if (is_best || n_changes > 1) {
        change.setZero();
    }
}

// Whether the looks are spent, or the time.
bool must_end(const Load& load, int i, int last, StepStatus& status) noexcept {
    if (i == std::max(last, 1)) {
        return true;
    }
    const bool is_late = i > 0 && !load.has_time();
    status = is_late ? StepStatus::out_of_time : status;
    return is_late;
}

// Out of time, the last change of base counts where nothing better than the first guess was found: that one has felt no load yet.
void keep_best(bool is_first, StepStatus status, Vector6& change) noexcept {
    if (!is_first || status != StepStatus::out_of_time) {
        change.setZero();
    }
}

}  // namespace

StepResult step_backward_euler(const IntegratorSettings& settings, const Inertia& inertia,
                               const Load& load, double time_s, double dt_s,
                               const RigidState& state, RigidState& next) noexcept {
    const Step step{inertia, load,  time_s + dt_s,
                    dt_s,    state, compute_angular_momentum_W(inertia, state)};
    Twist base = state.velocity_W;
    Vector6 change = Vector6::Zero();
    double base_size = std::numeric_limits<double>::infinity();
    bool is_whole = false;  // the change is all of a step of Newton
    bool is_first = true;   // base is the first guess
    int n_slow = 0;
    StepResult result{StepStatus::iterations_spent, 0};
    const int last = find_last_look(settings);
    for (int i = 0; i <= last; ++i) {
        const Twist velocity = add(base, change);
        Guess guess = evaluate(step, settings, velocity, find_wanted(i, last));
        if (!guess.residual.allFinite()) {
            return {StepStatus::not_finite, result.n_solves};
        }
        if (i > 0 && guess.size <= 1.0) {
            result.status = StepStatus::done;
            break;
        }
        const bool is_best = guess.size <= base_size;
        const bool is_end =
            is_lost(settings, dt_s, is_whole, change, base_size, guess.size, n_slow);
        if (is_best) {
            base = velocity;
            base_size = guess.size;
            is_first = i == 0;
        }
        if (is_end) {
            result.status = StepStatus::done;
            forget_worse(is_best, i, change);
            break;
        }
        if (must_end(load, i, last, result.status)) {
            keep_best(is_first, result.status, change);
            break;
        }
        if (!is_best) {
            change *= 0.5;
            is_whole = false;
            continue;
        }
        if (i > 0) {
            guess = evaluate(step, settings, velocity, Wanted::matrix_too);
        }
        ++result.n_solves;
        const StepStatus solved = solve(inertia, guess, change);
        if (solved != StepStatus::done) {
            return {solved, result.n_solves};
        }
        is_whole = true;
    }
    next = compute_state(step, add(base, change));
    return result;
}

}  // namespace fulcrum
