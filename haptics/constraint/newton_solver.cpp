#include "haptics/constraint/newton_solver.h"

#include "haptics/constraint/complementarity.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kLeastStiffening = 1.0e-9;  // below it rounding of u is felt in p
constexpr double kSlowRound = 0.1;           // a round that leaves more of the residual is slow
constexpr int kMostIdle = 3;      // steps with s following that gain nothing, before it is held
constexpr int kMostAttempts = 3;  // to let s follow, the first from last step's impulses
constexpr double kGain = 0.5;
constexpr int kMostHalvings = 4;
// What is near is solved once more: impulses that last step's error is left in would be taken as right for the next steps, and
// the error add up to the tolerance.
constexpr double kPolished = 0.01;
constexpr double kNearlySmallest = 0.1;  // E's slope against the residual when l is corrected

}  // namespace

NewtonSolver::NewtonSolver(const ContactSolverSettings& settings, const ContactCapacity& capacity)
    : settings_(settings),
      motion_(capacity.bodies),
      matrix_(capacity.bodies),
      contact_room_(static_cast<std::size_t>(std::max(capacity.contacts, 0))),
      row_room_(static_cast<std::size_t>(std::max(capacity.rows, 0))),
      slope_(static_cast<std::size_t>(std::max(capacity.bodies, 0)), Vector6::Zero()),
      step_(capacity.bodies),
      before_(capacity.bodies) {}

bool NewtonSolver::prepare(const ContactProblem& problem,
                           std::span<const double> friction) noexcept {
    const std::span<const ConstrainedBody> bodies = problem.bodies();
    contacts_ = {contact_room_.data(), problem.contacts().size()};
    rows_ = {row_room_.data(), problem.rows().size()};
    n_bodies_ = bodies.size();
    matrix_.begin(static_cast<int>(bodies.size()));
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const ContactConstraint& c = problem.contacts()[i];
        matrix_.add_pair(c.body_a, c.body_b);
        Contact& contact = contacts_[i];
        contact.weight = compute_weight(bodies, c);
        contact.friction = friction[i];
        contact.p = c.impulse_Ns;
        contact.state = project_impulse(settings_.friction_shape, friction[i], contact.p);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const RowConstraint& r = problem.rows()[i];
        matrix_.add_pair(r.body_a, r.body_b);
        rows_[i].weight = compute_weight(bodies, r);
        rows_[i].p = std::clamp(r.impulse, r.least, r.most);
    }
    return matrix_.find_order();
}

void NewtonSolver::set_stiffness(const ContactProblem& problem, double eps) noexcept {
    eps_ = eps;
    built_ = false;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact& contact = contacts_[i];
        contact.compliance = eps * contact.weight;
        contact.stiffness = 1.0 / (problem.contacts()[i].softness_per_kg + contact.compliance);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        Row& row = rows_[i];
        row.compliance = eps * row.weight;
        // A row that moves nothing pushes nothing.
        row.stiffness =
            row.weight > 0.0 ? 1.0 / (problem.rows()[i].softness + row.compliance) : 0.0;
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
        contact.u =
            compute_relative_velocity(c, motion_.velocity(c.body_a), motion_.velocity(c.body_b)) -
            c.target_m_per_s;
        const Vector3 y = contact.u + c.softness_per_kg * c.impulse_Ns;
        worst = std::max(worst, compute_residual(settings_.friction_shape, contact.friction,
                                                 contact.weight, y, c.impulse_Ns));
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const RowConstraint& r = problem.rows()[i];
        Row& row = rows_[i];
        row.u =
            compute_relative_velocity(r, motion_.velocity(r.body_a), motion_.velocity(r.body_b)) -
            r.target;
        if (row.weight > 0.0) {
            worst = std::max(
                worst, compute_residual(r, row.weight, row.u + r.softness * r.impulse, r.impulse));
        }
    }
    return worst;
}

double NewtonSolver::move_to_impulses(ContactProblem& problem) noexcept {
    apply_impulses(problem, motion_);
    return measure(problem);
}

void NewtonSolver::start_multipliers(const ContactProblem& problem) noexcept {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact& contact = contacts_[i];
        contact.l = contact.p;
        contact.shift = problem.contacts()[i].slides
                            ? compute_lift(settings_.friction_shape, contact.friction, contact.u)
                            : 0.0;
    }
    for (Row& row : rows_) {
        row.l = row.p;
    }
}

void NewtonSolver::project(Contact& contact, double along) const noexcept {
    Vector3 velocity = contact.u + along * contact.du;
    velocity.x() += contact.shift;
    contact.q = contact.stiffness * (contact.compliance * contact.l - velocity);
    contact.p = contact.q;
    contact.state = project_impulse(settings_.friction_shape, contact.friction, contact.p);
}

void NewtonSolver::project(const RowConstraint& constraint, Row& row, double along) noexcept {
    const double q = row.stiffness * (row.compliance * row.l - row.u - along * row.du);
    row.p = std::clamp(q, constraint.least, constraint.most);
    row.side = q > constraint.most ? 1 : (q < constraint.least ? -1 : 0);
    row.free = row.side == 0 && row.stiffness > 0.0;
}

NewtonSolver::Fit NewtonSolver::evaluate(const ContactProblem& problem) noexcept {
    Fit fit;
    const FrictionShape shape = settings_.friction_shape;
    motion_.clear_momenta(problem.bodies().size());
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const ContactConstraint& c = problem.contacts()[i];
        Contact& contact = contacts_[i];
        contact.u =
            compute_relative_velocity(c, motion_.velocity(c.body_a), motion_.velocity(c.body_b)) -
            c.target_m_per_s;
        const double lift = compute_lift(shape, contact.friction, contact.u);
        if (coulomb_) {
            contact.shift = lift;
        }
        project(contact, 0.0);
        const Vector3 y = contact.u + c.softness_per_kg * contact.p;
        fit.residual = std::max(
            fit.residual, compute_residual(shape, contact.friction, contact.weight, y, contact.p));
        if (contact.state.pressed) {
            fit.shift = std::max(fit.shift, std::abs(lift - contact.shift));
        }
        add_impulse(c, contact.p, motion_.momentum(c.body_a), motion_.momentum(c.body_b));
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const RowConstraint& r = problem.rows()[i];
        Row& row = rows_[i];
        row.u =
            compute_relative_velocity(r, motion_.velocity(r.body_a), motion_.velocity(r.body_b)) -
            r.target;
        project(r, row, 0.0);
        if (row.weight > 0.0) {
            fit.residual = std::max(
                fit.residual, compute_residual(r, row.weight, row.u + r.softness * row.p, row.p));
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
    return fit;
}

void NewtonSolver::update_multipliers() noexcept {
    for (Contact& contact : contacts_) {
        contact.l = contact.p;
        contact.shift = compute_lift(settings_.friction_shape, contact.friction, contact.u);
    }
    for (Row& row : rows_) {
        row.l = row.p;
    }
}

void NewtonSolver::begin_attempt() noexcept {
    coulomb_ = true;
    n_idle_ = 0;
    ++n_attempts_;
    attempt_fits_ = HUGE_VAL;
    before_.copy_velocities(motion_, n_bodies_);
    for (Contact& contact : contacts_) {
        contact.l_before = contact.l;
        contact.shift_before = contact.shift;
    }
    for (Row& row : rows_) {
        row.l_before = row.l;
    }
}

void NewtonSolver::end_attempt() noexcept {
    coulomb_ = false;
    built_ = false;
    motion_.copy_velocities(before_, n_bodies_);
    for (Contact& contact : contacts_) {
        contact.l = contact.l_before;
        contact.shift = contact.shift_before;
    }
    for (Row& row : rows_) {
        row.l = row.l_before;
    }
}

bool NewtonSolver::correct(const ContactProblem& problem, const Fit& fit,
                           double tolerance) noexcept {
    if (coulomb_) {
        // It goes on while each few steps gain.
        const double fits = std::max(fit.residual, fit.defect);
        n_idle_ = fits < kGain * attempt_fits_ ? 0 : n_idle_ + 1;
        attempt_fits_ = std::min(attempt_fits_, fits);
        if (n_idle_ > kMostIdle) {
            end_attempt();
            return true;
        }
    }
    if (fit.defect > kNearlySmallest * std::max(fit.residual, tolerance)) {
        return false;
    }
    const bool lifts = !coulomb_ && fit.shift > kNearlySmallest * fit.residual;
    if (lifts && n_attempts_ == kMostAttempts) {
        // Impulses that fit the shift as it is are the answer when E is at its smallest.
        given_up_ = fit.defect <= kNearlySmallest * tolerance;
        return false;
    }
    update_multipliers();
    if (lifts) {
        begin_attempt();
    } else if (fit.residual > kSlowRound * residual_before_ && eps_ > kLeastStiffening) {
        set_stiffness(problem, std::max(kSlowRound * eps_, kLeastStiffening));
    }
    residual_before_ = fit.residual;
    return true;
}

double NewtonSolver::iterate(ContactProblem& problem, double tolerance,
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
        const double fits = std::max(fit.residual, fit.defect);
        if (fits < best) {
            best = fits;
            keep(problem);
        }
        const bool near = fits <= tolerance;
        if ((near && (polished || fits <= kPolished * tolerance)) ||
            report.n_iterations == settings_.max_iterations || !std::isfinite(fits)) {
            return best;
        }
        polished = near;
        if (correct(problem, fit, tolerance)) {
            fit = evaluate(problem);
        }
        if (given_up_) {
            ++report.n_regularised;
            return best;
        }
        energy = fit.energy;
        along = step(problem, report);
    }
}

SolveReport NewtonSolver::solve(ContactProblem& problem, std::span<const double> friction,
                                double tolerance) noexcept {
    SolveReport report;
    const bool has_order = prepare(problem, friction);
    keep(problem);
    report.residual_m_per_s = move_to_impulses(problem);
    if (has_order && !(report.residual_m_per_s <= tolerance)) {
        set_stiffness(problem, settings_.stiffening);
        start_multipliers(problem);
        n_attempts_ = 0;
        given_up_ = false;
        begin_attempt();
        const double found = iterate(problem, tolerance, report);
        if (!(found < HUGE_VAL)) {
            // Nothing that came out is a number: what the bodies would do by themselves is.
            for (Contact& contact : contacts_) {
                contact.p.setZero();
            }
            for (std::size_t i = 0; i < rows_.size(); ++i) {
                rows_[i].p = std::clamp(0.0, problem.rows()[i].least, problem.rows()[i].most);
            }
            keep(problem);
            ++report.n_regularised;
        }
        report.residual_m_per_s = move_to_impulses(problem);
    }
    report.converged = report.residual_m_per_s <= tolerance;
    return report;
}

}  // namespace fulcrum
