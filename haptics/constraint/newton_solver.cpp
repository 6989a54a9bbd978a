#include "haptics/constraint/newton_solver.h"

#include "haptics/constraint/complementarity.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum {
namespace {

constexpr int kMostHalvings = 4;
// What is near is solved once more: impulses that last step's error is left in would be taken as right for the next steps, and
// the error add up to the tolerance.
constexpr double kPolished = 0.01;
// After a step that was solved, last step's impulses are taken as they are only where they are nearer than the tolerance by this:
// they hold what took back the error of the velocities before, as much as the tolerance.
constexpr double kUnsettled = 0.1;
// Of the problem's velocities: what impulses would make of the bodies they push, where those had nothing to push back. A billion
// times is more than any stack of masses asks for, so they grow without end.
constexpr double kMostPush = 1.0e9;
constexpr int kGuessesShare = 3;  // of all systems, as a part: for guesses
constexpr int kMostLiftRounds = 50;
constexpr double kSameLift = 1.0e-12;

}  // namespace

NewtonSolver::NewtonSolver(const ContactSolverSettings& settings, const ContactCapacity& capacity)
    : settings_(settings),
      motion_(capacity.bodies),
      matrix_(capacity.bodies),
      sets_(settings, capacity),
      contact_room_(static_cast<std::size_t>(std::max(capacity.contacts, 0))),
      row_room_(static_cast<std::size_t>(std::max(capacity.rows, 0))),
      slope_(static_cast<std::size_t>(std::max(capacity.bodies, 0)), Vector6::Zero()),
      step_(capacity.bodies),
      before_(capacity.bodies) {}

void NewtonSolver::prepare(const ContactProblem& problem,
                           std::span<const double> friction) noexcept {
    contacts_ = {contact_room_.data(), problem.contacts().size()};
    rows_ = {row_room_.data(), problem.rows().size()};
    n_bodies_ = problem.bodies().size();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const ContactConstraint& c = problem.contacts()[i];
        Contact& contact = contacts_[i];
        contact.friction = friction[i];
        contact.softness = c.softness_per_kg;
        contact.p = c.impulse_Ns;
        contact.state = project_impulse(settings_.friction_shape, friction[i], contact.p);
        contact.started = contact.p;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const RowConstraint& r = problem.rows()[i];
        rows_[i].started = rows_[i].p = std::clamp(r.impulse, r.least, r.most);
    }
}

bool NewtonSolver::find_order(const ContactProblem& problem) noexcept {
    matrix_.begin(static_cast<int>(n_bodies_));
    for (const ContactConstraint& c : problem.contacts()) {
        matrix_.add_pair(c.body_a, c.body_b);
    }
    for (const RowConstraint& r : problem.rows()) {
        matrix_.add_pair(r.body_a, r.body_b);
    }
    return matrix_.find_order();
}

void NewtonSolver::set_stiffness(const ContactProblem& problem, double eps) noexcept {
    eps_ = eps;
    built_ = false;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact& contact = contacts_[i];
        contact.compliance = eps * problem.contacts()[i].weight_per_kg;
        contact.stiffness = 1.0 / (contact.softness + contact.compliance);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        Row& row = rows_[i];
        const RowConstraint& r = problem.rows()[i];
        row.compliance = eps * r.weight;
        // A row that moves nothing pushes nothing.
        row.stiffness = r.weight > 0.0 ? 1.0 / (r.softness + row.compliance) : 0.0;
    }
}

void NewtonSolver::keep(ContactProblem& problem) const noexcept {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        problem.contacts()[i].impulse_Ns = contacts_[i].p;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        problem.rows()[i].impulse = rows_[i].p;
    }
}

double NewtonSolver::measure(const ContactProblem& problem) noexcept {
    double worst = 0.0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const ContactConstraint& c = problem.contacts()[i];
        Contact& contact = contacts_[i];
        contact.u = compute_miss(c, motion_);
        const Vector3 y = contact.u + c.softness_per_kg * c.impulse_Ns;
        worst = take_worse(worst, compute_residual(settings_.friction_shape, contact.friction,
                                                   c.weight_per_kg, y, c.impulse_Ns));
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const RowConstraint& r = problem.rows()[i];
        Row& row = rows_[i];
        row.u = compute_miss(r, motion_);
        if (r.weight > 0.0) {
            worst = take_worse(
                worst, compute_residual(r, r.weight, row.u + r.softness * r.impulse, r.impulse));
        }
    }
    return worst;
}

double NewtonSolver::move_to_impulses(ContactProblem& problem) noexcept {
    apply_impulses(problem, motion_);
    return measure(problem);
}

void NewtonSolver::project(Contact& contact, double along) const noexcept {
    Vector3 velocity = contact.u + along * contact.du;
    velocity.x() += contact.now.shift;
    contact.q = contact.stiffness * (contact.compliance * contact.now.l - velocity);
    contact.p = contact.q;
    contact.state = project_impulse(settings_.friction_shape, contact.friction, contact.p);
}

void NewtonSolver::project(const RowConstraint& constraint, Row& row, double along) noexcept {
    const double q = row.stiffness * (row.compliance * row.l - row.u - along * row.du);
    row.p = std::clamp(q, constraint.least, constraint.most);
    row.side = q > constraint.most ? 1 : (q < constraint.least ? -1 : 0);
    row.free = row.side == 0 && row.stiffness > 0.0;
}

// s and p that fit each other. Where R > 0, p changes y and so s, by less than s changed: rounds meet.
void NewtonSolver::follow_slip(Contact& contact) const noexcept {
    contact.now.shift = compute_lift(settings_.friction_shape, contact.friction, contact.u);
    project(contact, 0.0);
    for (int i = 0; contact.softness > 0.0 && i < kMostLiftRounds; ++i) {
        const double lift = find_lift(contact);
        const double change = std::abs(lift - contact.now.shift);
        contact.now.shift = lift;
        project(contact, 0.0);
        if (!(change > kSameLift * lift)) {
            return;
        }
    }
}

void NewtonSolver::evaluate_contact(const ContactConstraint& c, Contact& contact,
                                    Fit& fit) noexcept {
    contact.u = compute_miss(c, motion_);
    if (coulomb_) {
        follow_slip(contact);
    } else {
        project(contact, 0.0);
    }
    const Vector3 y = contact.u + c.softness_per_kg * contact.p;
    fit.residual =
        take_worse(fit.residual, compute_residual(settings_.friction_shape, contact.friction,
                                                  c.weight_per_kg, y, contact.p));
    if (contact.state.pressed) {
        fit.shift = take_worse(fit.shift, std::abs(find_lift(contact) - contact.now.shift));
        fit.push = take_worse(fit.push, c.weight_per_kg * contact.p.x());
    }
    add_impulse(c, contact.p, motion_.momentum(c.body_a), motion_.momentum(c.body_b));
}

NewtonSolver::Fit NewtonSolver::evaluate(const ContactProblem& problem) noexcept {
    Fit fit;
    motion_.clear_momenta(problem.bodies().size());
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        evaluate_contact(problem.contacts()[i], contacts_[i], fit);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const RowConstraint& r = problem.rows()[i];
        Row& row = rows_[i];
        row.u = compute_miss(r, motion_);
        project(r, row, 0.0);
        if (r.weight > 0.0) {
            fit.residual = take_worse(
                fit.residual, compute_residual(r, r.weight, row.u + r.softness * row.p, row.p));
            fit.push = take_worse(fit.push, r.weight * std::abs(row.p));
        }
        add_impulse(r, row.p, motion_.momentum(r.body_a), motion_.momentum(r.body_b));
    }
    int i = 0;
    for (const ConstrainedBody& body : problem.bodies()) {
        const Vector6 defect = motion_.velocity(i) - body.free_velocity_W -
                               compute_velocity_change(body, motion_.momentum(i));
        fit.defect = std::max(fit.defect, defect.cwiseAbs().maxCoeff());
        Vector6& slope = slope_[static_cast<std::size_t>(i++)];
        slope = compute_momentum(body, defect);
        fit.energy += defect.dot(slope);
    }
    fit.defect = std::isfinite(fit.energy) ? fit.defect : fit.energy;
    return fit;
}

void NewtonSolver::iterate(ContactProblem& problem, double tolerance,
                           SolveReport& report) noexcept {
    double best = HUGE_VAL;
    residual_before_ = HUGE_VAL;
    bool polished = false;
    Fit fit;
    double energy = 0.0;
    double along = 0.0;
    while (true) {
        fit = evaluate(problem);
        // Where s follows, E is not what falls: the defect is, or the step is shortened.
        for (int i = 0; coulomb_ && along > 0.0 && fit.energy > energy && i < kMostHalvings; ++i) {
            along *= 0.5;
            for (int body = 0; body < static_cast<int>(n_bodies_); ++body) {
                motion_.velocity(body) -= along * step_.velocity(body);
            }
            fit = evaluate(problem);
        }
        const double fits = take_worse(fit.residual, fit.defect);
        given_up_ = fit.push > kMostPush * tolerance / settings_.tolerance_m_per_s;
        if (fits < best && !given_up_) {
            best = fits;
            keep(problem);
        }
        const bool near = fits <= tolerance;
        if ((near && (polished || fits <= kPolished * tolerance)) ||
            report.n_iterations == settings_.max_iterations || !std::isfinite(fits)) {
            return;
        }
        polished |= near;
        if (!given_up_ && correct(problem, fit, tolerance)) {
            fit = evaluate(problem);
        }
        if (given_up_) {
            ++report.n_regularised;
            return;
        }
        energy = fit.energy;
        along = step(problem, report);
    }
}

// What was found, what it started from or no impulses: that which is nearest to an answer.
double NewtonSolver::take_least(ContactProblem& problem, double started, double found) noexcept {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        contacts_[i].q = std::exchange(problem.contacts()[i].impulse_Ns, Vector3(Vector3::Zero()));
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        RowConstraint& r = problem.rows()[i];
        rows_[i].p = std::exchange(r.impulse, std::clamp(0.0, r.least, r.most));
    }
    const double none = move_to_impulses(problem);
    if (none < found && none < started) {
        return none;
    }
    const bool takes_found = found < HUGE_VAL && !(started <= found);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        contacts_[i].p = takes_found ? contacts_[i].q : contacts_[i].started;
    }
    for (Row& row : rows_) {
        row.p = takes_found ? row.p : row.started;
    }
    keep(problem);
    return move_to_impulses(problem);
}

// False where they are not found: then the impulses are those that were.
bool NewtonSolver::guess_sets(ContactProblem& problem, std::span<const double> friction,
                              double tolerance, SolveReport& report) noexcept {
    const int most = std::min(kMostGuesses, settings_.max_iterations / kGuessesShare);
    const SetSolver::Answer answer =
        sets_.solve(problem, friction, tolerance, most, matrix_, motion_);
    report.n_iterations += answer.n_guesses;
    const double residual = move_to_impulses(problem);
    if (answer.found && residual <= tolerance) {
        report.residual_m_per_s = residual;
        return true;
    }
    keep(problem);
    if (answer.found) {
        (void)move_to_impulses(problem);
    }
    return false;
}

SolveReport NewtonSolver::solve(ContactProblem& problem, std::span<const double> friction,
                                double tolerance) noexcept {
    SolveReport report;
    prepare(problem, friction);
    keep(problem);
    const double started = move_to_impulses(problem);
    report.residual_m_per_s = started;
    const double taken = problem.is_settled() ? tolerance : kUnsettled * tolerance;
    if (!(started <= taken) && find_order(problem) &&
        !guess_sets(problem, friction, tolerance, report)) {
        set_stiffness(problem, settings_.stiffening);
        start_multipliers(problem);
        n_attempts_ = 0;
        given_up_ = false;
        coulomb_ = false;
        if (!sticks(problem)) {
            begin_attempt();
        }
        iterate(problem, tolerance, report);
        report.residual_m_per_s = move_to_impulses(problem);
        report.n_regularised += std::isfinite(report.residual_m_per_s) ? 0 : 1;
        if (!(report.residual_m_per_s <= tolerance)) {
            report.residual_m_per_s = take_least(problem, started, report.residual_m_per_s);
        }
    }
    report.converged = report.residual_m_per_s <= tolerance;
    return report;
}

}  // namespace fulcrum
