#include "haptics/constraint/contact_solver.h"

#include "haptics/constraint/complementarity.h"
#include "haptics/constraint/contact_motion.h"

#include <algorithm>
#include <utility>

namespace fulcrum {
namespace {

// The tolerance grows with the largest velocity, for rounding does.
double find_scale(const ContactProblem& problem) noexcept {
    double most = 1.0;
    for (const ConstrainedBody& body : problem.bodies()) {
        most = std::max(most, body.free_velocity_W.cwiseAbs().maxCoeff());
    }
    for (const ContactConstraint& contact : problem.contacts()) {
        most = std::max(most, contact.target_m_per_s.cwiseAbs().maxCoeff());
    }
    for (const RowConstraint& row : problem.rows()) {
        most = std::max(most, std::abs(row.target));
    }
    return most;
}

// A contact slips where it moves over the surface by more than the answer is uncertain, its residual.
constexpr double kSlipTolerances = 100.0;
// Bodies that are left approaching this fast, m/s at velocities of 1 m/s, were not solved.
constexpr double kPoor = 1.0e-3;

// The greatest share of all impulses that gives no energy.
double find_passive_share(const ContactProblem& problem) noexcept {
    const std::span<const ConstrainedBody> bodies = problem.bodies();
    const Vector6 still = Vector6::Zero();
    const auto before = [&](int body) -> const Vector6& {
        return body == kGround ? still : bodies[static_cast<std::size_t>(body)].free_velocity_W;
    };
    const auto after = [&](int body) -> const Vector6& {
        return body == kGround ? still : bodies[static_cast<std::size_t>(body)].velocity_W;
    };
    double first_J = 0.0;
    double last_J = 0.0;
    for (const ContactConstraint& c : problem.contacts()) {
        const Vector3& p = c.impulse_Ns;
        const double asked = p.dot(c.target_m_per_s);
        first_J += p.dot(compute_relative_velocity(c, before(c.body_a), before(c.body_b))) - asked;
        last_J += p.dot(compute_relative_velocity(c, after(c.body_a), after(c.body_b))) - asked;
    }
    for (const RowConstraint& r : problem.rows()) {
        const double asked = r.impulse * r.target;
        first_J +=
            r.impulse * compute_relative_velocity(r, before(r.body_a), before(r.body_b)) - asked;
        last_J +=
            r.impulse * compute_relative_velocity(r, after(r.body_a), after(r.body_b)) - asked;
    }
    const double twice_J = first_J + last_J;
    return twice_J <= 0.0 ? 1.0 : std::clamp(-2.0 * first_J / (last_J - first_J), 0.0, 1.0);
}

}  // namespace

bool ContactSolver::note_sliding(ContactProblem& problem, double uncertain_m_per_s,
                                 bool may_change) noexcept {
    const std::span<const ConstrainedBody> bodies = problem.bodies();
    const Vector6 still = Vector6::Zero();
    const auto velocity = [&](int body) -> const Vector6& {
        return body == kGround ? still : bodies[static_cast<std::size_t>(body)].velocity_W;
    };
    bool again = false;
    std::size_t i = 0;
    for (ContactConstraint& c : problem.contacts()) {
        const Vector3 y = compute_relative_velocity(c, velocity(c.body_a), velocity(c.body_b)) -
                          c.target_m_per_s + c.softness_per_kg * c.impulse_Ns;
        c.slides = c.impulse_Ns.x() > 0.0 &&
                   y.tail<2>().cwiseAbs().maxCoeff() > kSlipTolerances * uncertain_m_per_s;
        if (c.slides && may_change && friction_[i] > c.dynamic_friction) {
            friction_[i] = c.dynamic_friction;
            again = true;
        }
        ++i;
    }
    return again;
}

void ContactSolver::exchange_impulses(ContactProblem& problem) noexcept {
    std::size_t i = 0;
    for (ContactConstraint& c : problem.contacts()) {
        std::swap(c.impulse_Ns, kept_contacts_[i++]);
    }
    i = 0;
    for (RowConstraint& row : problem.rows()) {
        std::swap(row.impulse, kept_rows_[i++]);
    }
}

// False where it is not tried; else the nearer answer is in the problem and in the report.
bool ContactSolver::pivot(ContactProblem& problem, std::span<const double> friction,
                          double tolerance, SolveReport& report) noexcept {
    const std::size_t n_rows = 3 * problem.contacts().size() + problem.rows().size();
    if (!pivots_ || n_rows > static_cast<std::size_t>(kMostPivotRows)) {
        return false;
    }
    exchange_impulses(problem);
    const SolveReport pivoted = pivots_->solve(problem, friction, tolerance);
    report.n_iterations += pivoted.n_iterations;
    report.n_pivots += pivoted.n_pivots;
    if (pivoted.residual_m_per_s < report.residual_m_per_s) {
        report.residual_m_per_s = pivoted.residual_m_per_s;
        report.converged = pivoted.converged;
        report.n_regularised += pivoted.n_regularised;
        ++report.n_pivoted;
    } else {
        exchange_impulses(problem);
        apply_impulses(problem, motion_);
    }
    return true;
}

void ContactSolver::hold_energy(ContactProblem& problem, std::span<const double> friction,
                                SolveReport& report) noexcept {
    const double share = find_passive_share(problem);
    if (share == 1.0) {
        return;
    }
    ++report.n_regularised;
    for (ContactConstraint& c : problem.contacts()) {
        c.impulse_Ns *= share;
    }
    for (RowConstraint& row : problem.rows()) {
        row.impulse = std::clamp(share * row.impulse, row.least, row.most);
    }
    apply_impulses(problem, motion_);
    report.residual_m_per_s = compute_residual(problem, settings_.friction_shape, friction);
}

SolveReport ContactSolver::solve_bounded(ContactProblem& problem, std::span<const double> friction,
                                         double tolerance) noexcept {
    SolveReport report = bounded_->solve(problem, friction, tolerance);
    ++report.n_bounded;
    hold_energy(problem, friction, report);
    report.converged = report.residual_m_per_s <= tolerance;
    return report;
}

SolveReport ContactSolver::solve_once(ContactProblem& problem, std::span<const double> friction,
                                      double tolerance) noexcept {
    if (is_bounded(problem)) {
        return solve_bounded(problem, friction, tolerance);
    }
    std::size_t i = 0;
    for (const ContactConstraint& c : problem.contacts()) {
        kept_contacts_[i++] = c.impulse_Ns;
    }
    i = 0;
    for (const RowConstraint& row : problem.rows()) {
        kept_rows_[i++] = row.impulse;
    }
    SolveReport report = method_->solve(problem, friction, tolerance);
    const bool tried_pivots = !report.converged && pivot(problem, friction, tolerance, report);
    const double poor = kPoor * tolerance / settings_.tolerance_m_per_s;
    if (report.converged || report.residual_m_per_s <= poor) {
        return report;
    }
    ++report.n_regularised;
    if (!rounds_) {
        return report;
    }
    // Twice, the second time from what was nearer: it sets the bodies' velocities too.
    SolveReport rounds{.residual_m_per_s = HUGE_VAL};
    if (!tried_pivots) {
        exchange_impulses(problem);
        rounds = rounds_->solve(problem, friction, tolerance);
        if (!(rounds.residual_m_per_s < report.residual_m_per_s)) {
            exchange_impulses(problem);
        }
    }
    if (!(rounds.residual_m_per_s < report.residual_m_per_s)) {
        rounds = rounds_->solve(problem, friction, tolerance);
    }
    report.residual_m_per_s = rounds.residual_m_per_s;
    report.converged = rounds.converged;
    report.n_iterations += rounds.n_iterations;
    return report;
}

SolveReport ContactSolver::solve(ContactProblem& problem) noexcept {
    const std::span<ContactConstraint> contacts = problem.contacts();
    if (problem.bodies().size() > static_cast<std::size_t>(capacity_.bodies) ||
        contacts.size() > friction_.size() ||
        problem.rows().size() > static_cast<std::size_t>(capacity_.rows)) {
        return {.residual_m_per_s = HUGE_VAL, .converged = false};
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        friction_[i] =
            contacts[i].slides ? contacts[i].dynamic_friction : contacts[i].static_friction;
    }
    const double tolerance = settings_.tolerance_m_per_s * find_scale(problem);
    const std::span<const double> friction(friction_.data(), contacts.size());
    SolveReport report = solve_once(problem, friction, tolerance);
    const auto uncertain = [&] { return std::max(tolerance, report.residual_m_per_s); };
    const int most_rounds = is_bounded(problem) ? 1 : settings_.friction_rounds;
    for (int round = 1; note_sliding(problem, uncertain(), round < most_rounds); ++round) {
        const SolveReport next = solve_once(problem, friction, tolerance);
        report = {next.residual_m_per_s,
                  report.n_iterations + next.n_iterations,
                  report.n_pivots + next.n_pivots,
                  report.n_regularised + next.n_regularised,
                  report.n_bounded + next.n_bounded,
                  report.n_pivoted + next.n_pivoted,
                  next.converged};
    }
    return report;
}

}  // namespace fulcrum
